#include "rewrite/collect/collector.h"

namespace symreal::rewrite {
using namespace clang;

void Collector::conversion(CastExpr const *cast) {
  Expr const *from = cast->getSubExpr();
  bool const to_integer = cast->getCastKind() == CK_FloatingToIntegral;
  if ((!to_integer && cast->getCastKind() != CK_FloatingCast) || cast->isTypeDependent() || !reals_.is_real(from))
    return;
  later([this, cast, from, to_integer] {
    std::optional<Span> const span = map_.range(from->getSourceRange());
    if (span && !compared_exactly_.contains(cast))
      facts_.conversions.insert({*span, cast->getType().getUnqualifiedType().getAsString(map_.language()), to_integer});
  });
}

// x == 0.L: the same as in double where the constant is a double.
bool Collector::compares_exactly(Expr const *side, Expr const *constant) {
  auto const *cast = dyn_cast<ImplicitCastExpr>(side->IgnoreParens());
  if (!cast || !cast->getType()->isSpecificBuiltinType(BuiltinType::LongDouble)) return false;
  llvm::APFloat value(0.);
  if (!reals_.is_real(cast->getSubExpr()) || !constant->EvaluateAsFloat(value, context_)) return false;
  bool is_rounded = false;
  value.convert(llvm::APFloat::IEEEdouble(), llvm::APFloat::rmNearestTiesToEven, &is_rounded);
  if (is_rounded) return false;
  compared_exactly_.insert(cast);
  wrap(constant->IgnoreImpCasts(), Use::literal);
  return true;
}

void Collector::comparison(BinaryOperator const *comparison) {
  if (comparison->isTypeDependent()) return;
  Expr const *left = comparison->getLHS(), *right = comparison->getRHS();
  for (Expr const *side : {left, right})
    if (auto const *cast = dyn_cast<ImplicitCastExpr>(side); cast && cast->getType()->isPointerType()) {
      compared_pointers_.insert(cast);
      // C++ compares with void *, and const with non-const pointers. An operand lacks a context that implies its type.
      QualType const from = cast->getSubExpr()->getType(), to = cast->getType();
      if (is_pointer_of_c(cast) && !from->isVoidPointerType() &&
          !context_.hasSameUnqualifiedType(from->getPointeeType(), to->getPointeeType()))
        wrap(cast->getSubExpr(), Use::cast, spelled(cast->getType()));
    }
  if (!reals_.is_real(left) && !reals_.is_real(right) && !compares_exactly(left, right) &&
      !compares_exactly(right, left))
    return;
  if (std::optional<Span> const span = map_.token(comparison->getOperatorLoc())) facts_.comparisons.insert(*span);
}

} // namespace symreal::rewrite
