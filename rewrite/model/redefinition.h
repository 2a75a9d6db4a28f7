// What another file must say so that it can define a function anew.
#pragma once

#include "rewrite/facts/signature.h"
#include "rewrite/source/clang.h"

#include <string>
#include <vector>

namespace symreal::rewrite {

// A name in the items of a kernel, and what it is.
struct NamedItem {
  std::string name;
  clang::ValueDecl const *declaration;
};

Redefinition redefinition(clang::FunctionDecl const *function, std::vector<NamedItem> const &names);

} // namespace symreal::rewrite
