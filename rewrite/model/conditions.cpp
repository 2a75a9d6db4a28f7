#include "rewrite/model/conditions.h"

#include "rewrite/model/library.h"
#include "rewrite/source/walk.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

Expr const *bare(Expr const *expression) {
  while (true) {
    Expr const *inner = expression->IgnoreParenImpCasts();
    if (auto const *full = dyn_cast<FullExpr>(inner)) inner = full->getSubExpr();
    if (inner == expression) return inner;
    expression = inner;
  }
}

// A REAL, or an integer that keeps its dependency.
bool is_symbolic(Expr const *expression, Reals const &reals) {
  return reals.is_real(expression) || reals.is_symbolic_integer(expression);
}

bool is_truth_value(Expr const *expression) {
  if (expression->getType()->isBooleanType()) return true;
  if (auto const *binary = dyn_cast<BinaryOperator>(expression))
    return binary->isComparisonOp() || binary->isLogicalOp();
  auto const *unary = dyn_cast<UnaryOperator>(expression);
  return unary && unary->getOpcode() == UO_LNot;
}

// Whether an expression may be evaluated where the original would not evaluate it. Accesses through pointers and
// indices may be only if nothing but conditions on REALs guarded them.
class Harmless : public Walk {
public:
  Harmless(Reals const &reals, bool may_access) : reals_(reals), may_access_(may_access) {}
  bool ok = true;
  bool VisitCallExpr(CallExpr *call) override {
    FunctionDecl const *function = call->getDirectCallee();
    return ok = function && (reals_.is_math(function) || is_std_function(function, {"abs", "min", "max", "clamp"}));
  }
  bool VisitArraySubscriptExpr(ArraySubscriptExpr *) override { return ok = may_access_; }
  bool VisitMemberExpr(MemberExpr *member) override {
    return ok = may_access_ || !member->isArrow() || member->isImplicitAccess();
  }
  bool VisitUnaryOperator(UnaryOperator *unary) override {
    return ok = !unary->isIncrementDecrementOp() && (may_access_ || unary->getOpcode() != UO_Deref);
  }
  bool VisitBinaryOperator(BinaryOperator *binary) override {
    bool const divides = binary->getOpcode() == BO_Div || binary->getOpcode() == BO_Rem;
    return ok = !binary->isAssignmentOp() && (!divides || Reals::is_double(binary->getType()));
  }
  bool VisitCastExpr(CastExpr *cast) override {
    return ok = cast->getCastKind() != CK_FloatingToIntegral || !reals_.is_real(cast->getSubExpr());
  }
  bool VisitLambdaExpr(LambdaExpr *) override { return ok = false; }
  bool VisitStmtExpr(StmtExpr *) override { return ok = false; }

private:
  Reals const &reals_;
  bool const may_access_;
};

// The operands of `&` bind tighter than it, those of `&&` need not.
bool binds_tighter(Expr const *operand) {
  auto const *binary = dyn_cast<BinaryOperator>(operand->IgnoreImpCasts());
  return !binary || !binary->isBitwiseOp();
}

// `&&` or `||` without parentheses around it.
bool is_bare_joint(Expr const *operand) {
  auto const *binary = dyn_cast<BinaryOperator>(operand->IgnoreImpCasts());
  return binary && binary->isLogicalOp();
}

class Comparisons : public Walk {
public:
  explicit Comparisons(Reals const &reals) : reals_(reals) {}
  bool TraverseLambdaExpr(LambdaExpr *) override { return true; }
  bool VisitBinaryOperator(BinaryOperator *binary) override {
    found = found || (binary->isComparisonOp() &&
                      (is_symbolic(binary->getLHS(), reals_) || is_symbolic(binary->getRHS(), reals_)));
    return !found;
  }
  bool found = false;

private:
  Reals const &reals_;
};

class RealParts : public Walk {
public:
  explicit RealParts(Reals const &reals) : reals_(reals) {}
  bool TraverseLambdaExpr(LambdaExpr *) override { return true; }
  bool TraverseUnaryExprOrTypeTraitExpr(UnaryExprOrTypeTraitExpr *) override { return true; }
  bool VisitExpr(Expr *expression) override {
    found = found || (!expression->isLValue() && reals_.is_real(expression)) ||
            (isa<ImplicitCastExpr>(expression) && reals_.is_real(cast<ImplicitCastExpr>(expression)->getSubExpr()));
    return !found;
  }
  bool found = false;

private:
  Reals const &reals_;
};

// Whether the call classifies a REAL: isnan, isless and similar functions.
bool asks_of_real(CallExpr const *call, Reals const &reals) {
  FunctionDecl const *function = call->getDirectCallee();
  if (!function || call->getNumArgs() == 0 || (function->getBuiltinID() == 0 && !reals.is_math(function))) return false;
  llvm::StringRef name = function->getName();
  name.consume_front("__builtin_");
  name.consume_front("__");
  if (!name.starts_with("isnan") && !name.starts_with("isinf") && !name.starts_with("isfinite") &&
      !library::has(name, library::COMPARES))
    return false;
  return llvm::any_of(call->arguments(),
                      [&](Expr const *argument) { return reals.is_real(argument->IgnoreParenImpCasts()); });
}

} // namespace

bool Conditions::mentions_comparison(Expr const *expression) const {
  Comparisons comparisons(reals_);
  comparisons.TraverseStmt(const_cast<Expr *>(expression));
  return comparisons.found;
}

bool Conditions::mentions_real(Expr const *expression) const {
  RealParts parts(reals_);
  parts.TraverseStmt(const_cast<Expr *>(expression));
  return parts.found;
}

Condition Conditions::classify(Expr const *condition) const {
  Condition result;
  if (condition && !condition->isTypeDependent()) visit(condition, result);
  return result;
}

Conditions::Kind Conditions::visit(Expr const *expression, Condition &result) const {
  expression = bare(expression);
  if (Reals::is_double(expression->getType())) {
    if (!reals_.is_real(expression)) return Kind::plain;
    result.is_real = true;
    return Kind::truth_of_real;
  }
  if (auto const *binary = dyn_cast<BinaryOperator>(expression)) {
    if (binary->isLogicalOp()) return visit_joint(binary, result);
    bool const compares = binary->isComparisonOp() && binary->getOpcode() != BO_Cmp &&
                          (is_symbolic(binary->getLHS(), reals_) || is_symbolic(binary->getRHS(), reals_));
    if (compares) {
      result.is_real = true;
      return Kind::real;
    }
  }
  if (auto const *call = dyn_cast<CallExpr>(expression); call && asks_of_real(call, reals_)) {
    result.is_real = true;
    return Kind::real;
  }
  if (auto const *unary = dyn_cast<UnaryOperator>(expression); unary && unary->getOpcode() == UO_LNot) {
    Kind const kind = visit(unary->getSubExpr(), result);
    if (kind == Kind::truth_of_real && !result.blocker)
      result.blocker = {unary->getOperatorLoc(), {ReasonId::not_of_number}};
    return kind;
  }
  if (!mentions_comparison(expression)) return Kind::plain;
  result.is_real = true;
  if (!result.blocker) result.blocker = {expression->getExprLoc(), {ReasonId::more_than_comparisons}};
  return Kind::plain;
}

Conditions::Kind Conditions::visit_joint(BinaryOperator const *joint, Condition &result) const {
  Expr const *left = joint->getLHS(), *right = joint->getRHS();
  Kind const a = visit(left, result), b = visit(right, result);
  if (a == Kind::plain && b == Kind::plain) return Kind::plain;
  Kind const joined = a == Kind::real && b == Kind::real ? Kind::real : Kind::mixed;
  std::string const name = "'" + joint->getOpcodeStr().str() + "'";
  auto const block = [&](Reason reason) {
    if (!result.blocker) result.blocker = {joint->getOperatorLoc(), std::move(reason)};
    return joined;
  };
  if (a == Kind::truth_of_real || b == Kind::truth_of_real) return block({ReasonId::joined_number, name});
  for (Expr const *operand : {left, right})
    if (!binds_tighter(operand) || !is_truth_value(bare(operand))) return block({ReasonId::joined_other, name});
  Harmless harmless(reals_, a == Kind::real);
  harmless.TraverseStmt(const_cast<Expr *>(right));
  if (!harmless.ok) return block({ReasonId::right_side, name});
  std::optional<Span> const token = map_.token(joint->getOperatorLoc());
  if (!token) return block({ReasonId::joint_by_macro, name});
  // `&` and `|` bind tighter than the `&&` and `||` that stay in a plain operand.
  for (auto const &[operand, kind] : {std::pair(left, a), std::pair(right, b)}) {
    if (kind != Kind::plain || !is_bare_joint(operand)) continue;
    std::optional<Span> const whole = map_.range(operand->getSourceRange());
    if (!whole) return block({ReasonId::joined_by_macro, name});
    result.joints.push_back({*whole, "SYMREAL_REAL_PLAIN(", ")"});
  }
  result.joints.push_back({*token, joint->getOpcode() == BO_LAnd ? "SYMREAL_REAL_AND" : "SYMREAL_REAL_OR", "", true});
  return joined;
}

} // namespace symreal::rewrite
