// What evaluating an expression reads and changes, as far as it matters in which order two are evaluated.
#pragma once

#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"

namespace symreal::rewrite {

struct Effects {
  bool changes = false; // an object that others may know
  bool reads = false;   // such an object
  bool talks = false;   // to a library: it prints, or draws a number
};

class EffectAnalysis {
public:
  explicit EffectAnalysis(Reals const &reals) : reals_(reals) {}

  // Of an operand in this function (null: in none).
  Effects of(clang::Expr const *operand, clang::FunctionDecl const *function);

private:
  friend class OperandEffects;
  friend class BodyEffects;
  enum class Reach : unsigned char { none, own_object, anything };
  Reach reach(clang::FunctionDecl const *function);
  Reach reach_of_call(clang::CallExpr const *call);
  bool only_talks(clang::CallExpr const *call) const;
  // The variables of a function whose address somebody may have.
  llvm::SmallPtrSet<clang::VarDecl const *, 8> const &known_elsewhere(clang::FunctionDecl const *function);

  Reals const &reals_;
  llvm::DenseMap<clang::FunctionDecl const *, Reach> reach_;
  std::map<clang::FunctionDecl const *, llvm::SmallPtrSet<clang::VarDecl const *, 8>> known_elsewhere_;
};

} // namespace symreal::rewrite
