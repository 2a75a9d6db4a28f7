// A bit-field that is narrower than int is an int wherever it is computed with. Two compute with the type that it is
// declared with: g++, where it is an arm of `?:` or on the right of `n /= f.b`, and a template that has the place of an
// operator, as those of integers that are computed from real numbers.
#include "rewrite/collect/collector.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

// The signed type that an unsigned bit-field is promoted to; none for anything else.
QualType promoted_field(Expr const *operand, ASTContext const &context) {
  Expr const *field = operand->IgnoreParenImpCasts();
  if (!isa<MemberExpr>(field) || !field->getType()->isUnsignedIntegerType()) return {};
  QualType const promoted = context.isPromotableBitField(const_cast<Expr *>(field));
  return !promoted.isNull() && promoted->isSignedIntegerType() ? promoted : QualType();
}

} // namespace

// Sources of C become C++; the compiler of a source in C++ is g++ itself.
void Collector::narrow_fields(AbstractConditionalOperator const *choice) {
  if (map_.language().CPlusPlus || !choice->getType()->isIntegerType() || !map_.in_roots(choice->getQuestionLoc()))
    return;
  auto const *binary = dyn_cast<BinaryConditionalOperator>(choice);
  for (Expr const *arm : {binary ? binary->getCommon() : choice->getTrueExpr(), choice->getFalseExpr()})
    if (QualType const type = promoted_field(arm, context_); !type.isNull())
      wrap(arm->IgnoreImpCasts(), Use::cast, spelled(type));
}

// Beside an integer that is computed from real numbers.
void Collector::narrow_fields(BinaryOperator const *operation) {
  if (operation->isLogicalOp() || operation->isCommaOp() || operation->getOpcode() == BO_Assign) return;
  if (operation->isCompoundAssignmentOp() && map_.language().CPlusPlus) return;
  if (!map_.in_roots(operation->getOperatorLoc())) return;
  auto const look = [&](Expr const *operand, Expr const *other) {
    QualType const type = promoted_field(operand, context_);
    if (!type.isNull() && (other->isInstantiationDependent() || may_be_truth(other)))
      wrap(operand->IgnoreImpCasts(), Use::before, "(" + spelled(type) + ")");
  };
  if (!operation->isCompoundAssignmentOp()) look(operation->getLHS(), operation->getRHS());
  look(operation->getRHS(), operation->getLHS());
}

} // namespace symreal::rewrite
