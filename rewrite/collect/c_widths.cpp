// Bit-fields of C that are wider or narrower than int.
#include "rewrite/collect/c_widths.h"
#include "rewrite/collect/handlers.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

std::string words(unsigned bits, bool is_signed) { return std::to_string(bits) + (is_signed ? ", true" : ", false"); }

// The text of a macro's body is compiled with other operands as well.
bool is_in_body(SourceMap const &map, SourceLocation operation) {
  return !map.sources().getSLocEntry(map.frame(operation)).isFile();
}
constexpr char const *in_body = "a macro computes with a bit-field that is wider than int";

// The signed type that an unsigned bit-field is promoted to; none for anything else.
QualType promoted_field(Expr const *operand, ASTContext const &context) {
  Expr const *field = operand->IgnoreParenImpCasts();
  if (!isa<MemberExpr>(field) || !field->getType()->isUnsignedIntegerType()) return {};
  QualType const promoted = context.isPromotableBitField(const_cast<Expr *>(field));
  return !promoted.isNull() && promoted->isSignedIntegerType() ? promoted : QualType();
}

class WideFields : public SyntaxHandler {
public:
  explicit WideFields(SyntaxTable &table) : SyntaxHandler(table), widths_(context_) {
    on<BinaryOperator>(ANYWHERE, &WideFields::c_widths);
    on<UnaryOperator>(ANYWHERE, &WideFields::c_widths);
    on<ConditionalOperator>(ANYWHERE, &WideFields::c_widths);
  }

private:
  // An operand of an operation that is computed in that width.
  void as_width(SourceLocation operation, Expr const *operand, Width width) {
    Width const own = widths_.of(operand);
    bool const is_literal = isa<IntegerLiteral>(operand->IgnoreParenImpCasts()); // which is not negative
    if (!is_literal && (own.bits != width.bits || own.is_signed != width.is_signed))
      wrap_for(operation, operand->IgnoreImpCasts(), Use::as_width, words(width.bits, width.is_signed));
  }

  void c_widths(BinaryOperator const *operation) {
    if (map_.language().CPlusPlus || operation->isLogicalOp() || operation->isCommaOp()) return;
    if (operation->getOpcode() == BO_Assign || !map_.in_roots(operation->getOperatorLoc())) return;
    Width const left = widths_.of(operation->getLHS()), right = widths_.of(operation->getRHS());
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

  void c_widths(UnaryOperator const *operation) {
    if (map_.language().CPlusPlus || !map_.in_roots(operation->getOperatorLoc())) return;
    if (operation->getOpcode() != UO_Minus && operation->getOpcode() != UO_Not) return;
    Width const width = widths_.of(operation->getSubExpr());
    if (width.is_narrow() && is_in_body(map_, operation->getOperatorLoc()))
      report(DiagnosticId::c_source, operation->getOperatorLoc(), in_body);
    else if (width.is_narrow())
      wrap(operation, Use::width, words(width.bits, width.is_signed));
  }

  void c_widths(ConditionalOperator const *choice) {
    if (map_.language().CPlusPlus || !choice->getType()->isIntegerType()) return;
    if (!map_.in_roots(choice->getQuestionLoc())) return;
    Width const yes = widths_.of(choice->getTrueExpr()), no = widths_.of(choice->getFalseExpr());
    if (yes.bits == 0 || no.bits == 0 || (!yes.is_narrow() && !no.is_narrow())) return;
    if (is_in_body(map_, choice->getQuestionLoc()))
      return report(DiagnosticId::c_source, choice->getQuestionLoc(), in_body);
    for (Expr const *arm : {choice->getTrueExpr(), choice->getFalseExpr()})
      as_width(choice->getQuestionLoc(), arm, common(yes, no));
  }

  Widths widths_;
};

class NarrowFields : public SyntaxHandler {
public:
  explicit NarrowFields(SyntaxTable &table) : SyntaxHandler(table) {
    on<AbstractConditionalOperator>(ANYWHERE, &NarrowFields::narrow_fields);
    on<BinaryOperator>(NUMBERS, &NarrowFields::narrow_fields);
  }

private:
  // A bit-field that is narrower than int is an int wherever it is computed with. Two compute with the type that it is
  // declared with: g++, where it is an arm of `?:` or on the right of `n /= f.b`, and a template that has the place of
  // an operator, as those of integers that are computed from real numbers. Sources of C become C++; the compiler of a
  // source in C++ is g++ itself.
  void narrow_fields(AbstractConditionalOperator const *choice) {
    if (map_.language().CPlusPlus || !choice->getType()->isIntegerType() || !map_.in_roots(choice->getQuestionLoc()))
      return;
    auto const *binary = dyn_cast<BinaryConditionalOperator>(choice);
    for (Expr const *arm : {binary ? binary->getCommon() : choice->getTrueExpr(), choice->getFalseExpr()})
      if (QualType const type = promoted_field(arm, context_); !type.isNull())
        wrap(arm->IgnoreImpCasts(), Use::cast, spelled(type));
  }

  // Beside an integer that is computed from real numbers.
  void narrow_fields(BinaryOperator const *operation) {
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
};

} // namespace

Width common(Width one, Width other) {
  if (one.bits != other.bits) return one.bits > other.bits ? one : other;
  return one.is_signed ? other : one;
}

Width Widths::of(Expr const *expression) {
  expression = expression->IgnoreParenImpCasts();
  if (!expression->getType()->isIntegerType()) return {};
  if (auto const known = known_.find(expression); known != known_.end()) return known->second;
  Width const width = computed(expression);
  return known_[expression] = width;
}

Width Widths::computed(Expr const *expression) {
  if (FieldDecl const *field = const_cast<Expr *>(expression)->getSourceBitField();
      field && isa<MemberExpr>(expression)) {
    unsigned const bits = field->getBitWidthValue(context_);
    bool const is_signed = field->getType()->isSignedIntegerType();
    return bits < 32 ? Width{32, true} : Width{bits, is_signed};
  }
  if (auto const *unary = dyn_cast<UnaryOperator>(expression);
      unary && unary->getOpcode() != UO_LNot && unary->getOpcode() != UO_Deref)
    return of(unary->getSubExpr());
  if (auto const *binary = dyn_cast<BinaryOperator>(expression)) {
    if (binary->isComparisonOp() || binary->isLogicalOp()) return {32, true};
    if (binary->isCommaOp()) return of(binary->getRHS());
    if (binary->isAssignmentOp() || binary->isShiftOp()) return of(binary->getLHS());
    return common(of(binary->getLHS()), of(binary->getRHS()));
  }
  if (auto const *choice = dyn_cast<ConditionalOperator>(expression))
    return common(of(choice->getTrueExpr()), of(choice->getFalseExpr()));
  QualType const type = expression->getType();
  QualType const promoted =
      context_.isPromotableIntegerType(type) ? context_.getPromotedIntegerType(type) : type.getCanonicalType();
  return {static_cast<unsigned>(context_.getIntWidth(promoted)), promoted->isSignedIntegerOrEnumerationType()};
}

void add_c_widths(SyntaxTable &table) {
  table.add<WideFields>();
  table.add<NarrowFields>();
}

} // namespace symreal::rewrite
