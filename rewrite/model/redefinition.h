// Redefinition of a function in another file: the includes, declarations and scopes that it needs.
#pragma once

#include "rewrite/facts/signature.h"
#include "rewrite/source/clang.h"

#include <string>
#include <vector>

namespace symreal::rewrite {

// A name in the items of a kernel, and its declaration.
struct NamedItem {
  std::string name;
  clang::ValueDecl const *declaration;
};

Redefinition redefinition(clang::FunctionDecl const *function, std::vector<NamedItem> const &names);

} // namespace symreal::rewrite
