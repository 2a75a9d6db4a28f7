// Expressions of C whose type differs in C++: enumerations are integers in C, a truth value and a character are ints,
// and gcc computes with bit-fields in types of their own. The differences are the silent ones of the C++ standard's
// annex on C
// ([diff.iso]).
#include "engine/support/mutation/is_dropped.h"
#include "rewrite/collect/collector.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

// Operand behind implicit conversions, which have no text in C and are not done in C++.
Expr const *operand_of(Expr const *expression) {
  while (true) {
    expression = expression->IgnoreParens();
    auto const *cast = dyn_cast<ImplicitCastExpr>(expression);
    bool const is_through = cast && (cast->getCastKind() == CK_IntegralCast || cast->getCastKind() == CK_NoOp ||
                                     cast->getCastKind() == CK_LValueToRValue);
    if (!is_through) return expression;
    expression = cast->getSubExpr();
  }
}

// The enumeration that an expression is of in C++; null if it is of none.
EnumDecl const *enumeration_in_cpp(Expr const *expression) {
  expression = operand_of(expression);
  if (auto const *binary = dyn_cast<BinaryOperator>(expression); binary && binary->isCommaOp())
    return enumeration_in_cpp(binary->getRHS());
  if (auto const *choice = dyn_cast<ConditionalOperator>(expression)) {
    EnumDecl const *yes = enumeration_in_cpp(choice->getTrueExpr()), *no = enumeration_in_cpp(choice->getFalseExpr());
    // An object among its arms is counted, and so is the whole (c_choice).
    return yes == no && choice->getType()->isSignedIntegerType() ? yes : nullptr;
  }
  if (auto const *name = dyn_cast<DeclRefExpr>(expression))
    if (auto const *enumerator = dyn_cast<EnumConstantDecl>(name->getDecl()))
      return cast<EnumDecl>(enumerator->getDeclContext())->getCanonicalDecl();
  auto const *type = expression->getType()->getAs<EnumType>();
  return type ? type->getDecl()->getCanonicalDecl() : nullptr;
}

// Promoted type of the enumeration in C++ ([conv.prom]): the first type that holds all values it could have.
QualType promoted_in_cpp(EnumDecl const *enumeration, ASTContext const &context) {
  EnumDecl const *definition = enumeration->getDefinition();
  if (!definition) return context.IntTy;
  unsigned const positive = definition->getNumPositiveBits(), negative = definition->getNumNegativeBits();
  for (QualType type : {context.IntTy, context.UnsignedIntTy, context.LongTy, context.UnsignedLongTy}) {
    bool const is_signed = type->isSignedIntegerType();
    unsigned const needed = is_signed ? std::max(negative, positive + 1) : positive;
    if (needed <= context.getIntWidth(type) && (is_signed || negative == 0)) return type;
  }
  return context.UnsignedLongLongTy;
}

// Kinds of expressions for which sizeof differs or is an error in C++: in C `?:` and `,` give values, not lvalues.
enum class Other { none, truth, character, enumeration, array, bit_field };

bool is_classification(Expr const *expression) { // isnan, signbit and their like, which give a bool there
  auto const *call = dyn_cast<CallExpr>(expression);
  FunctionDecl const *function = call ? call->getDirectCallee() : nullptr;
  if (!function || !function->getIdentifier() || !call->getType()->isIntegerType()) return false;
  llvm::StringRef name = function->getName();
  name.consume_front("__builtin_");
  return (name.starts_with("is") || name.starts_with("signbit")) && Reals::is_math_name(name);
}

// Whether an arm is of a narrow type: if both are, `?:` has that type in C++, and int in C.
bool is_narrow(Expr const *expression) {
  expression = operand_of(expression);
  if (isa<CharacterLiteral>(expression)) return true;
  if (auto const *binary = dyn_cast<BinaryOperator>(expression); binary && !binary->isAssignmentOp())
    return binary->isComparisonOp() || binary->isLogicalOp();
  if (auto const *unary = dyn_cast<UnaryOperator>(expression); unary && unary->getOpcode() == UO_LNot) return true;
  auto const *type = expression->getType()->getAs<BuiltinType>();
  if (!type) return false;
  switch (type->getKind()) {
  case BuiltinType::Bool:
  case BuiltinType::Char_S:
  case BuiltinType::Char_U:
  case BuiltinType::SChar:
  case BuiltinType::UChar:
  case BuiltinType::Short:
  case BuiltinType::UShort: return true;
  default: return false;
  }
}

Other other_type(Expr const *expression, SourceMap const &map) {
  expression = expression->IgnoreParens();
  if (auto const *cast = dyn_cast<ImplicitCastExpr>(expression))
    return cast->getCastKind() == CK_ArrayToPointerDecay ? Other::array : other_type(cast->getSubExpr(), map);
  if (isa<CharacterLiteral>(expression)) return Other::character;
  if (auto const *unary = dyn_cast<UnaryOperator>(expression)) {
    if (unary->getOpcode() == UO_Extension) return other_type(unary->getSubExpr(), map);
    return unary->getOpcode() == UO_LNot ? Other::truth : Other::none;
  }
  if (auto const *binary = dyn_cast<BinaryOperator>(expression)) {
    if (binary->isCommaOp()) return other_type(binary->getRHS(), map);
    return binary->isComparisonOp() || binary->isLogicalOp() ? Other::truth : Other::none;
  }
  if (auto const *choice = dyn_cast<AbstractConditionalOperator>(expression)) {
    Other const yes = other_type(choice->getTrueExpr(), map), no = other_type(choice->getFalseExpr(), map);
    if (yes == Other::bit_field || no == Other::bit_field) return Other::bit_field;
    if (is_narrow(choice->getTrueExpr()) && is_narrow(choice->getFalseExpr())) return Other::truth;
    return yes == no ? yes : Other::none;
  }
  if (auto const *literal = dyn_cast<IntegerLiteral>(expression); literal && literal->getLocation().isMacroID()) {
    llvm::StringRef const macro = Lexer::getImmediateMacroName(literal->getLocation(), map.sources(), map.language());
    return macro == "true" || macro == "false" ? Other::truth : Other::none; // words of the language there
  }
  if (is_classification(expression)) return Other::truth;
  if (isa<MemberExpr>(expression) && const_cast<Expr *>(expression)->getSourceBitField()) return Other::bit_field;
  auto const *name = dyn_cast<DeclRefExpr>(expression);
  return name && isa<EnumConstantDecl>(name->getDecl()) ? Other::enumeration : Other::none;
}

// An object whose type follows from an expression, and which may be an integer that stays symbolic.
bool may_be_symbolic(Expr const *expression) {
  auto const *name = dyn_cast<DeclRefExpr>(expression->IgnoreParenImpCasts());
  auto const *variable = name ? dyn_cast<VarDecl>(name->getDecl()) : nullptr;
  if (!variable || !variable->getType()->isIntegerType()) return false;
  return variable->getType()->getContainedAutoType() || variable->getType()->getAs<TypeOfExprType>();
}

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

} // namespace

// The integer type of an enumeration's expression.
QualType Collector::counted_as(Expr const *enumeration) const {
  Expr const *written = operand_of(enumeration);
  auto const *type = written->getType()->getAs<EnumType>();
  if (!type) return map_.language().CPlusPlus ? context_.IntTy : written->getType();
  if (QualType const promoted = context_.isPromotableBitField(const_cast<Expr *>(written)); !promoted.isNull())
    return promoted;
  QualType const promoted = type->getDecl()->getPromotionType();
  return promoted.isNull() ? context_.IntTy : promoted;
}

void Collector::c_operand(SourceLocation operation, Expr const *operand) {
  if (map_.language().CPlusPlus || !map_.in_roots(operation)) return;
  if (auto const *cast = dyn_cast<ImplicitCastExpr>(operand->IgnoreParens()))
    if (cast->getCastKind() == CK_IntegralToFloating && Reals::is_double(cast->getType())) return; // implicit_cast
  EnumDecl const *enumeration = enumeration_in_cpp(operand);
  if (!enumeration || enumeration->isFixed()) return;
  Expr const *written = operand_of(operand);
  QualType const in_c = counted_as(written);
  if (context_.hasSameUnqualifiedType(in_c, promoted_in_cpp(enumeration, context_))) return;
  // Other expansions of a macro's body may have another type; an enumerator is one in all of them.
  if (written->getType()->isEnumeralType())
    wrap_for(operation, operand->IgnoreImpCasts(), Use::counted);
  else
    wrap(written, Use::of_c, spelled(in_c));
}

void Collector::c_operation(BinaryOperator const *operation) {
  if (map_.language().CPlusPlus || operation->isLogicalOp() || operation->isCommaOp()) return;
  if (operation->isAssignmentOp() && !operation->isCompoundAssignmentOp()) return;
  QualType const left = operation->getLHS()->getType(), right = operation->getRHS()->getType();
  if (left->isPointerType() || right->isPointerType()) return;
  // Whether two integers of the size of an int are equal does not depend on their signs.
  if (operation->isEqualityOp() && context_.getTypeSize(left) == context_.getTypeSize(context_.IntTy)) return;
  if (!operation->isCompoundAssignmentOp()) c_operand(operation->getOperatorLoc(), operation->getLHS());
  if (!operation->isShiftOp() && operation->getOpcode() != BO_ShlAssign && operation->getOpcode() != BO_ShrAssign)
    c_operand(operation->getOperatorLoc(), operation->getRHS());
}

void Collector::c_operation(UnaryOperator const *operation) {
  if (operation->getOpcode() == UO_Plus || operation->getOpcode() == UO_Minus || operation->getOpcode() == UO_Not)
    c_operand(operation->getOperatorLoc(), operation->getSubExpr());
  Expr const *counted = operation->getSubExpr();
  if (map_.language().CPlusPlus || !operation->isIncrementDecrementOp() || !counted->getType()->isBooleanType()) return;
  if (counted->refersToBitField())
    report(DiagnosticId::c_source, operation->getOperatorLoc(), "a bit-field that is a truth value is counted");
  else
    wrap(counted, Use::enumeration);
}

void Collector::c_type_asked(Expr const *operand, bool is_size) {
  if (map_.language().CPlusPlus || !map_.in_roots(operand->getBeginLoc())) return;
  Other const other = is_size && may_be_symbolic(operand) ? Other::truth : other_type(operand, map_);
  if (other == Other::none) return;
  if (other == Other::enumeration) {
    EnumDecl const *enumeration = enumeration_in_cpp(operand);
    if (!enumeration || !enumeration->getDefinition()) return;
    QualType const in_cpp = enumeration->getDefinition()->getIntegerType();
    if (is_size && context_.getTypeSize(in_cpp) == context_.getTypeSize(operand->getType())) return;
  }
  if (other == Other::bit_field) { // C++ rejects sizeof of it; Clang ignores its width
    Width const width = width_of(operand);
    QualType const type = width.bits <= 32  ? (width.is_signed ? context_.IntTy : context_.UnsignedIntTy)
                          : width.is_signed ? context_.LongLongTy
                                            : context_.UnsignedLongLongTy;
    return wrap(operand->IgnoreParens(), Use::cast, spelled(type));
  }
  // An object of a type asked for may hold values that depend on REALs, without a decision.
  if (auto const *comparison = dyn_cast<BinaryOperator>(operand->IgnoreParenImpCasts());
      !is_size && comparison && (reals_.is_real(comparison->getLHS()) || reals_.is_real(comparison->getRHS())))
    return wrap(operand->IgnoreParens(), Use::of_c, "SYMREAL_REAL_INT(int)");
  wrap(operand->IgnoreParens(), Use::of_c, spelled(operand->getType().getCanonicalType()));
}

// NULL is a pointer there, and an integer in C++.
static void null_control(Expr const *null, SourceMap const &map, Facts &facts) {
  SourceManager const &sources = map.sources();
  SourceLocation at = null->getBeginLoc();
  std::optional<Span> token;
  while (at.isMacroID() && !token) { // up to the name
    at = sources.isMacroArgExpansion(at) ? sources.getImmediateSpellingLoc(at)
                                         : sources.getImmediateExpansionRange(at).getBegin();
    token = map.token(at, "NULL");
  }
  if (token && !map.is_argument_of(at, "REAL_EITHER")) facts.wraps.insert({*token, Use::instead, "((void *)0)"});
}

// The controlling expression of _Generic; an integer that stays symbolic counts as its plain type (of_c.h).
void Collector::c_control(Expr const *control) {
  if (map_.language().CPlusPlus || !map_.in_roots(control->getBeginLoc()) || is_dropped("generic")) return;
  Expr const *written = control->IgnoreParenImpCasts();
  // The elements of a literal are const in C++.
  if (isa<StringLiteral>(written)) return wrap(written, Use::cast, spelled(control->getType()));
  if (control->getType()->isVoidPointerType() &&
      control->isNullPointerConstant(context_, Expr::NPC_NeverValueDependent))
    return null_control(written, map_, facts_);
  if (!control->getType()->isPointerType()) c_type_asked(control, /*is_size=*/false);
}

// Before C99 a decimal number that is too large for long is an unsigned long, later a larger type.
void Collector::c_literal(IntegerLiteral const *literal) {
  if (map_.language().CPlusPlus || map_.language().C99 || !literal->getType()->isUnsignedIntegerType()) return;
  std::optional<Span> const span = map_.token(literal->getLocation());
  if (!span) return;
  std::string const text = map_.text(*span, literal->getLocation());
  if (text.starts_with("0") || text.find_first_not_of("0123456789lL") != text.npos) return;
  wrap(literal, Use::cast, spelled(literal->getType()));
}

// Bit-fields wider than int: gcc computes with them in a type of just as many bits: `f.b << 1` loses the bits that do
// not fit. C++ uses the bit-field's declared type, as Clang does in both languages.

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

// A bit-field that is narrower than int is an int wherever it is computed with. Two compute with the type that it is
// declared with: g++, where it is an arm of `?:` or on the right of `n /= f.b`, and a template that has the place of an
// operator, as those of integers that are computed from real numbers.

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
