// Side effects of evaluating an expression, as far as they matter to the order of evaluation.
#pragma once

#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"

namespace symreal::rewrite {

struct Effects {
  bool changes = false; // an object known elsewhere
  bool reads = false;   // such an object
  bool talks = false;   // calls a library that prints or draws a random number
};

class EffectAnalysis {
public:
  explicit EffectAnalysis(Reals const &reals) : reals_(reals) {}

  // Effects of an operand in this function (null: outside of functions).
  Effects of(clang::Expr const *operand, clang::FunctionDecl const *function);

private:
  friend class OperandEffects;
  friend class BodyEffects;
  enum class Reach : unsigned char { none, own_object, anything };
  Reach reach(clang::FunctionDecl const *function);
  Reach reach_of_call(clang::CallExpr const *call);
  bool only_talks(clang::CallExpr const *call) const;
  // Variables of a function whose address may be known elsewhere.
  llvm::SmallPtrSet<clang::VarDecl const *, 8> const &known_elsewhere(clang::FunctionDecl const *function);

  Reals const &reals_;
  llvm::DenseMap<clang::FunctionDecl const *, Reach> reach_;
  std::map<clang::FunctionDecl const *, llvm::SmallPtrSet<clang::VarDecl const *, 8>> known_elsewhere_;
};

// Variables that an expression and its callees change and read by name. Accesses through pointers, and functions
// without a visible body, add nothing: the set is a lower bound.
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
