// A call or a construction whose function is known.
#pragma once

#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <optional>
#include <vector>

namespace symreal::rewrite {

struct CallSite {
  clang::Expr const *expression;
  clang::SourceLocation place; // of the call, as SourceMap::range_for takes it
  clang::FunctionDecl const *function;
  std::vector<clang::Expr const *> arguments; // those that are written, without the object of an operator
  bool is_overloaded;
};

std::optional<CallSite> call_site(clang::CallExpr const *call);
// Nullopt for a copy.
std::optional<CallSite> call_site(clang::CXXConstructExpr const *construction);

// Whether arguments become what the parameters declare. Functions of <cmath> take any number, and external ones stay as
// they are.
bool takes_as_declared(clang::FunctionDecl const *function, Reals const &reals);

// Whether the function is neither rewritten nor the runtime's.
bool is_outside(clang::FunctionDecl const *function, SourceMap const &map, Reals const &reals);

} // namespace symreal::rewrite
