// Expressions of C whose type differs in C++: enumerations are integers in C, a truth value and a character are ints.
// The differences are the silent ones of the C++ standard's annex on C ([diff.iso]).
#include "engine/support/mutation/is_dropped.h"
#include "rewrite/collect/c_widths.h"
#include "rewrite/collect/handlers.h"

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

// NULL is a pointer there, and an integer in C++.
void null_control(Expr const *null, SourceMap const &map, Facts &facts) {
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

class TypesOfC : public SyntaxHandler {
public:
  explicit TypesOfC(SyntaxTable &table) : SyntaxHandler(table) {
    on<BinaryOperator>(ANYWHERE, &TypesOfC::c_operation);
    on<UnaryOperator>(ANYWHERE, &TypesOfC::c_operation);
    on<ConditionalOperator>(ANYWHERE, &TypesOfC::c_choice);
    on<UnaryExprOrTypeTraitExpr>(ANYWHERE, &TypesOfC::c_type_asked);
    on<TypeOfExprTypeLoc>(ANYWHERE, &TypesOfC::c_type_asked);
    on<VarDecl>(ANYWHERE, &TypesOfC::c_type_asked);
    on<GenericSelectionExpr>(ANYWHERE, &TypesOfC::c_selection);
    on<IntegerLiteral>(ANYWHERE, &TypesOfC::c_literal);
  }

private:
  void c_choice(ConditionalOperator const *choice) {
    if (choice->getType()->isIntegerType())
      for (Expr const *arm : {choice->getTrueExpr(), choice->getFalseExpr()}) c_operand(choice->getQuestionLoc(), arm);
  }
  void c_type_asked(UnaryExprOrTypeTraitExpr const *expression) {
    if (!expression->isArgumentType())
      c_type_asked(expression->getArgumentExpr(), expression->getKind() == UETT_SizeOf);
  }
  void c_type_asked(TypeOfExprTypeLoc type) { c_type_asked(type.getUnderlyingExpr(), /*is_size=*/false); }
  void c_type_asked(VarDecl const *variable) {
    if (variable->hasInit() && variable->getType()->getContainedAutoType())
      c_type_asked(variable->getInit(), /*is_size=*/false);
  }
  void c_selection(GenericSelectionExpr const *selection) {
    if (selection->isExprPredicate()) c_control(selection->getControllingExpr());
  }

  void c_operand(SourceLocation operation, Expr const *operand) {
    if (map_.language().CPlusPlus || !map_.in_roots(operation)) return;
    if (auto const *cast = dyn_cast<ImplicitCastExpr>(operand->IgnoreParens()))
      if (cast->getCastKind() == CK_IntegralToFloating && Reals::is_double(cast->getType()))
        return; // a conversion (conversions.cpp)
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

  void c_operation(BinaryOperator const *operation) {
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

  void c_operation(UnaryOperator const *operation) {
    if (operation->getOpcode() == UO_Plus || operation->getOpcode() == UO_Minus || operation->getOpcode() == UO_Not)
      c_operand(operation->getOperatorLoc(), operation->getSubExpr());
    Expr const *counted = operation->getSubExpr();
    if (map_.language().CPlusPlus || !operation->isIncrementDecrementOp() || !counted->getType()->isBooleanType())
      return;
    if (counted->refersToBitField())
      report(DiagnosticId::c_source, operation->getOperatorLoc(), "a bit-field that is a truth value is counted");
    else
      wrap(counted, Use::enumeration);
  }

  void c_type_asked(Expr const *operand, bool is_size) {
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
      Width const width = Widths(context_).of(operand);
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

  // The controlling expression of _Generic; an integer that stays symbolic counts as its plain type (of_c.h).
  void c_control(Expr const *control) {
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
  void c_literal(IntegerLiteral const *literal) {
    if (map_.language().CPlusPlus || map_.language().C99 || !literal->getType()->isUnsignedIntegerType()) return;
    std::optional<Span> const span = map_.token(literal->getLocation());
    if (!span) return;
    std::string const text = map_.text(*span, literal->getLocation());
    if (text.starts_with("0") || text.find_first_not_of("0123456789lL") != text.npos) return;
    wrap(literal, Use::cast, spelled(literal->getType()));
  }
};

} // namespace

// The integer type of an enumeration's expression.
QualType SyntaxHandler::counted_as(Expr const *enumeration) const {
  Expr const *written = operand_of(enumeration);
  auto const *type = written->getType()->getAs<EnumType>();
  if (!type) return map_.language().CPlusPlus ? context_.IntTy : written->getType();
  if (QualType const promoted = context_.isPromotableBitField(const_cast<Expr *>(written)); !promoted.isNull())
    return promoted;
  QualType const promoted = type->getDecl()->getPromotionType();
  return promoted.isNull() ? context_.IntTy : promoted;
}

void add_c_types(SyntaxTable &table) { table.add<TypesOfC>(); }

} // namespace symreal::rewrite
