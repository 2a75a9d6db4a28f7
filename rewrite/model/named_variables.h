// Which variables evaluating an expression changes and reads by their names, in the functions that it calls as well.
// What is reached through pointers, and functions whose bodies are not seen, add nothing: what is told is certain.
#pragma once

#include "rewrite/source/clang.h"

namespace symreal::rewrite {

struct NamedVariables {
  llvm::SmallPtrSet<clang::VarDecl const *, 4> changed, read;

  // Does evaluating one change what evaluating the other reads or changes?
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
