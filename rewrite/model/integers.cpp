// Integers that stay symbolic, as far as their expressions tell (symbolic_ints.h).
#include "rewrite/model/conditions.h"
#include "rewrite/model/reals.h"

#include <algorithm>

namespace symreal::rewrite {
using namespace clang;

bool Reals::is_integer(QualType type) {
  if (type.isNull()) return false;
  type = type.getNonReferenceType();
  return type->isIntegerType() && !type->isBooleanType() && !type->isEnumeralType() && !type->isAnyCharacterType();
}

Expr const *Reals::spelled_integer(Expr const *expression) {
  while (true) {
    Expr const *inner = expression->IgnoreParens();
    if (auto const *full = dyn_cast<FullExpr>(inner)) inner = full->getSubExpr();
    if (auto const *temporary = dyn_cast<MaterializeTemporaryExpr>(inner)) inner = temporary->getSubExpr();
    if (auto const *cast = dyn_cast<ImplicitCastExpr>(inner))
      if (cast->getCastKind() == CK_LValueToRValue || cast->getCastKind() == CK_NoOp ||
          cast->getCastKind() == CK_IntegralCast)
        inner = cast->getSubExpr();
    if (inner == expression) return inner;
    expression = inner;
  }
}

bool Reals::rounds_to_integer(FunctionDecl const *function) const {
  if (!is_math(function)) return false;
  llvm::StringRef name = function->getName();
  name.consume_front("__builtin_");
  return llvm::is_contained({"lround", "llround", "lrint", "llrint"}, name);
}

bool Reals::integer_depends(Expr const *expression, llvm::function_ref<bool(CastExpr const *)> cast_does) const {
  expression = spelled_integer(expression);
  if (expression->isTypeDependent() || !is_integer(expression->getType())) return false;
  auto depends = [&](Expr const *part) { return integer_depends(part, cast_does); };
  if (auto const *cast = dyn_cast<CastExpr>(expression)) {
    // An explicit conversion in C++ has no effect by itself: its operand is the conversion.
    auto const *conversion = dyn_cast<ImplicitCastExpr>(cast->getSubExpr());
    if (cast->getCastKind() != CK_NoOp || !conversion || !conversion->isPartOfExplicitCast()) conversion = nullptr;
    CastExpr const *does = conversion ? conversion : cast;
    CastKind const kind = does->getCastKind();
    bool const converts =
        kind == CK_FloatingToIntegral
            ? is_real(does->getSubExpr())
            : (kind == CK_IntegralCast || kind == CK_NoOp || kind == CK_LValueToRValue) && depends(does->getSubExpr());
    return converts && cast_does(cast);
  }
  if (auto const *reference = dyn_cast<DeclRefExpr>(expression)) {
    auto const *variable = dyn_cast<VarDecl>(reference->getDecl());
    return variable && is_symbolic_integer(variable);
  }
  if (auto const *unary = dyn_cast<UnaryOperator>(expression))
    return (unary->getOpcode() == UO_Minus || unary->getOpcode() == UO_Plus || unary->getOpcode() == UO_Not ||
            unary->isIncrementDecrementOp()) &&
           depends(unary->getSubExpr());
  if (auto const *binary = dyn_cast<BinaryOperator>(expression)) {
    if (binary->isAssignmentOp()) return depends(binary->getLHS());
    return (binary->isAdditiveOp() || binary->isMultiplicativeOp() || binary->isShiftOp() || binary->isBitwiseOp()) &&
           (depends(binary->getLHS()) || depends(binary->getRHS()));
  }
  auto const *call = dyn_cast<CallExpr>(expression);
  FunctionDecl const *function = call ? call->getDirectCallee() : nullptr;
  if (!function) return false;
  if (external(function)) return true;
  if (rounds_to_integer(function)) return is_real(call->getArg(0));
  return is_std_function(function, {"min", "max", "clamp"}) && std::any_of(call->arg_begin(), call->arg_end(), depends);
}

bool Reals::is_symbolic_integer(Expr const *expression) const {
  return integer_depends(expression, [this](CastExpr const *cast) { return kept_casts_.contains(cast); });
}

} // namespace symreal::rewrite
