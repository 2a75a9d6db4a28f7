// Bit-fields wider than int: gcc computes with them in a type of just as many bits: `f.b << 1` loses the bits that do
// not fit. C++ uses the bit-field's declared type, as Clang does in both languages.
#include "rewrite/collect/collector.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

std::string words(unsigned bits, bool is_signed) { return std::to_string(bits) + (is_signed ? ", true" : ", false"); }

// The text of a macro's body is compiled with other operands as well.
bool is_in_body(SourceMap const &map, SourceLocation operation) {
  return !map.sources().getSLocEntry(map.frame(operation)).isFile();
}
constexpr char const *in_body = "a macro computes with a bit-field that is wider than int";

} // namespace

// The usual arithmetic conversions, on types of any width.
Collector::Width Collector::common(Width one, Width other) {
  if (one.bits != other.bits) return one.bits > other.bits ? one : other;
  return one.is_signed ? other : one;
}

Collector::Width Collector::width_of(Expr const *expression) {
  expression = expression->IgnoreParenImpCasts();
  if (!expression->getType()->isIntegerType()) return {};
  if (auto const known = widths_.find(expression); known != widths_.end()) return known->second;
  Width const width = computed_width(expression);
  return widths_[expression] = width;
}

Collector::Width Collector::computed_width(Expr const *expression) {
  if (FieldDecl const *field = const_cast<Expr *>(expression)->getSourceBitField();
      field && isa<MemberExpr>(expression)) {
    unsigned const bits = field->getBitWidthValue(context_);
    bool const is_signed = field->getType()->isSignedIntegerType();
    return bits < 32 ? Width{32, true} : Width{bits, is_signed};
  }
  if (auto const *unary = dyn_cast<UnaryOperator>(expression);
      unary && unary->getOpcode() != UO_LNot && unary->getOpcode() != UO_Deref)
    return width_of(unary->getSubExpr());
  if (auto const *binary = dyn_cast<BinaryOperator>(expression)) {
    if (binary->isComparisonOp() || binary->isLogicalOp()) return {32, true};
    if (binary->isCommaOp()) return width_of(binary->getRHS());
    if (binary->isAssignmentOp() || binary->isShiftOp()) return width_of(binary->getLHS());
    return common(width_of(binary->getLHS()), width_of(binary->getRHS()));
  }
  if (auto const *choice = dyn_cast<ConditionalOperator>(expression))
    return common(width_of(choice->getTrueExpr()), width_of(choice->getFalseExpr()));
  QualType const type = expression->getType();
  QualType const promoted =
      context_.isPromotableIntegerType(type) ? context_.getPromotedIntegerType(type) : type.getCanonicalType();
  return {static_cast<unsigned>(context_.getIntWidth(promoted)), promoted->isSignedIntegerOrEnumerationType()};
}

// An operand of an operation that is computed in that width.
void Collector::as_width(SourceLocation operation, Expr const *operand, Width width) {
  Width const own = width_of(operand);
  bool const is_literal = isa<IntegerLiteral>(operand->IgnoreParenImpCasts()); // which is not negative
  if (!is_literal && (own.bits != width.bits || own.is_signed != width.is_signed))
    wrap_for(operation, operand->IgnoreImpCasts(), Use::as_width, words(width.bits, width.is_signed));
}

void Collector::c_widths(BinaryOperator const *operation) {
  if (map_.language().CPlusPlus || operation->isLogicalOp() || operation->isCommaOp()) return;
  if (operation->getOpcode() == BO_Assign || !map_.in_roots(operation->getOperatorLoc())) return;
  Width const left = width_of(operation->getLHS()), right = width_of(operation->getRHS());
  if (left.bits == 0 || right.bits == 0 || (!left.is_narrow() && !right.is_narrow())) return;
  if (is_in_body(map_, operation->getOperatorLoc()))
    return report(DiagnosticId::c_source, operation->getOperatorLoc(), in_body);
  bool const is_shift =
      operation->isShiftOp() || operation->getOpcode() == BO_ShlAssign || operation->getOpcode() == BO_ShrAssign;
  Width const width = is_shift ? left : common(left, right);
  if (operation->isCompoundAssignmentOp()) {
    bool const divides = operation->getOpcode() == BO_DivAssign || operation->getOpcode() == BO_RemAssign;
    if (divides && !left.is_narrow() && left.is_signed && !width.is_signed)
      report(DiagnosticId::c_source, operation->getOperatorLoc(),
             "this divides by a bit-field of " + std::to_string(right.bits) +
                 " bits, and its left side is converted to an integer of that width");
    else if (!is_shift)
      as_width(operation->getOperatorLoc(), operation->getRHS(), width);
    return;
  }
  if (!is_shift)
    for (Expr const *operand : {operation->getLHS(), operation->getRHS()})
      as_width(operation->getOperatorLoc(), operand, width);
  if (!operation->isComparisonOp() && width.is_narrow())
    wrap(operation, Use::width, words(width.bits, width.is_signed));
}

void Collector::c_widths(UnaryOperator const *operation) {
  if (map_.language().CPlusPlus || !map_.in_roots(operation->getOperatorLoc())) return;
  if (operation->getOpcode() != UO_Minus && operation->getOpcode() != UO_Not) return;
  Width const width = width_of(operation->getSubExpr());
  if (width.is_narrow() && is_in_body(map_, operation->getOperatorLoc()))
    report(DiagnosticId::c_source, operation->getOperatorLoc(), in_body);
  else if (width.is_narrow())
    wrap(operation, Use::width, words(width.bits, width.is_signed));
}

void Collector::c_widths(ConditionalOperator const *choice) {
  if (map_.language().CPlusPlus || !choice->getType()->isIntegerType()) return;
  if (!map_.in_roots(choice->getQuestionLoc())) return;
  Width const yes = width_of(choice->getTrueExpr()), no = width_of(choice->getFalseExpr());
  if (yes.bits == 0 || no.bits == 0 || (!yes.is_narrow() && !no.is_narrow())) return;
  if (is_in_body(map_, choice->getQuestionLoc()))
    return report(DiagnosticId::c_source, choice->getQuestionLoc(), in_body);
  for (Expr const *arm : {choice->getTrueExpr(), choice->getFalseExpr()})
    as_width(choice->getQuestionLoc(), arm, common(yes, no));
}

} // namespace symreal::rewrite
