// Variables that an expression and its callees change and read by name. Accesses through pointers, and functions
// without a visible body, add nothing: the set is a lower bound.
#pragma once

#include "rewrite/source/clang.h"

namespace symreal::rewrite {

struct NamedVariables {
  llvm::SmallPtrSet<clang::VarDecl const *, 4> changed, read;

  // Whether evaluating one changes what evaluating the other reads or changes.
  bool meet(NamedVariables const &other) const;
};

class NamedVariableAnalysis {
public:
  NamedVariables of(clang::Expr const *expression);
  NamedVariables const &of(clang::FunctionDecl const *function);

private:
  std::map<clang::FunctionDecl const *, NamedVariables> functions_;
};

} // namespace symreal::rewrite
