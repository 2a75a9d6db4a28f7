#include "rewrite/recorder.h"

namespace symreal::rewrite {
using namespace clang;

void Recorder::to_integer(CastExpr const *cast) {
  Expr const *from = cast->getSubExpr();
  if (cast->getCastKind() != CK_FloatingToIntegral || cast->isTypeDependent() || !reals_.is_real(from)) return;
  if (std::optional<Span> const span = map_.range(from->getSourceRange()))
    facts_.to_integers.try_emplace(*span, cast->getType().getUnqualifiedType().getAsString(map_.language()));
}

void Recorder::comparison(BinaryOperator const *comparison) {
  if (comparison->isTypeDependent() || (!reals_.is_real(comparison->getLHS()) && !reals_.is_real(comparison->getRHS())))
    return;
  if (std::optional<Span> const span = map_.token(comparison->getOperatorLoc())) facts_.comparisons.insert(*span);
}

} // namespace symreal::rewrite
