// Conversions of numbers, enumerations and pointers, and what a scan reports of them.
#include "rewrite/collect/handlers.h"
#include "rewrite/model/library.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

// The type of an enumerator, which in C is an integer; null for other expressions.
EnumDecl const *enumeration_of(Expr const *expression) {
  auto const *name = dyn_cast<DeclRefExpr>(expression->IgnoreParenImpCasts());
  auto const *enumerator = name ? dyn_cast<EnumConstantDecl>(name->getDecl()) : nullptr;
  return enumerator ? cast<EnumDecl>(enumerator->getDeclContext())->getCanonicalDecl() : nullptr;
}

// Whether the type is an enumeration in C++. In C, that of ?: is an integer as well.
bool is_enumeration(Expr const *expression) {
  expression = expression->IgnoreParenImpCasts();
  if (auto const *choice = dyn_cast<ConditionalOperator>(expression))
    return is_enumeration(choice->getTrueExpr()) && is_enumeration(choice->getFalseExpr());
  if (EnumDecl const *enumeration = enumeration_of(expression)) return !enumeration->isScoped();
  return expression->getType()->isUnscopedEnumerationType();
}

// The conversion by a function of its class, if that comes first; or null.
ImplicitCastExpr const *conversion_by_class(Expr const *expression) {
  auto const *cast = dyn_cast<ImplicitCastExpr>(expression->IgnoreParens());
  auto const is_later = [](CastKind kind) {
    return kind == CK_LValueToRValue || kind == CK_IntegralCast || kind == CK_IntegralToFloating;
  };
  while (cast && is_later(cast->getCastKind())) cast = dyn_cast<ImplicitCastExpr>(cast->getSubExpr()->IgnoreParens());
  return cast && cast->getCastKind() == CK_UserDefinedConversion ? cast : nullptr;
}

// numeric_limits<NUMBER>::epsilon() in a macro is one text for all of its uses, and gives a REAL where they do.
bool gives_real_by_macro(Stmt const *part) {
  auto const *call = dyn_cast_or_null<CallExpr>(part);
  auto const *method = call ? dyn_cast_or_null<CXXMethodDecl>(call->getDirectCallee()) : nullptr;
  auto const *type = method ? dyn_cast<ClassTemplateSpecializationDecl>(method->getParent()) : nullptr;
  if (type && call->getBeginLoc().isMacroID() && Reals::is_double(call->getType())) {
    TemplateArgument const &argument = type->getTemplateArgs()[0];
    return argument.getKind() == TemplateArgument::Type && Reals::is_double(argument.getAsType());
  }
  return part && std::any_of(part->child_begin(), part->child_end(), gives_real_by_macro);
}

class Conversions : public SyntaxHandler {
public:
  explicit Conversions(SyntaxTable &table) : SyntaxHandler(table) {
    on<IfStmt>(ANYWHERE, &Conversions::condition<IfStmt>);
    on<WhileStmt>(ANYWHERE, &Conversions::condition<WhileStmt>);
    on<DoStmt>(ANYWHERE, &Conversions::condition<DoStmt>);
    on<ForStmt>(ANYWHERE, &Conversions::condition<ForStmt>);
    on<ConditionalOperator>(ANYWHERE, &Conversions::condition<ConditionalOperator>);
    on<UnaryOperator>(ANYWHERE, &Conversions::negation);
    on<BinaryOperator>(ANYWHERE, &Conversions::logical);
    on<ImplicitCastExpr>(NUMBERS, &Conversions::cast);
    on<CastExpr>(NUMBERS, &Conversions::conversion);
    on<BinaryOperator>(NUMBERS, &Conversions::comparison);
    on<CompoundAssignOperator>(NUMBERS, &Conversions::compound_assignment);
    on<BinaryOperator>(NUMBERS, &Conversions::converted_operands);
    on<UnaryOperator>(NUMBERS, &Conversions::converted_operand);
    on<UserDefinedLiteral>(NUMBERS, &Conversions::complex_literal);
    on<VarDecl>(ANYWHERE, &Conversions::constant);
  }

private:
  // Conditions convert to bool by themselves: no cast is needed in front of the decision.
  template <class Statement> void condition(Statement const *statement) { decides(statement->getCond()); }
  void negation(UnaryOperator const *operation) {
    if (operation->getOpcode() == UO_LNot) decides(operation->getSubExpr());
  }
  void logical(BinaryOperator const *operation) {
    if (!operation->isLogicalOp()) return;
    decides(operation->getLHS());
    decides(operation->getRHS());
  }
  // Most implicit casts read a variable or take an address.
  void cast(ImplicitCastExpr const *cast) {
    if (cast->getCastKind() != CK_LValueToRValue && cast->getCastKind() != CK_ArrayToPointerDecay &&
        cast->getCastKind() != CK_FunctionToPointerDecay)
      later([this, cast] { implicit_cast(cast); });
  }
  void conversion(CastExpr const *cast);
  void comparison(BinaryOperator const *comparison);
  void compound_assignment(CompoundAssignOperator const *assignment);
  void converted_operands(BinaryOperator const *operation);
  void converted_operand(UnaryOperator const *operation);
  void complex_literal(UserDefinedLiteral const *literal);
  void constant(VarDecl const *variable) {
    if (at_.passive == constant_variable || at_.passive == static_member) constant_initializer(variable->getInit());
  }

  void decides(Expr const *condition);
  void implicit_cast(ImplicitCastExpr const *cast);
  void converted_number(ImplicitCastExpr const *cast);
  void constant_initializer(Expr const *initializer);
  bool has_operator(OverloadedOperatorKind kind) const;
  bool compares_exactly(Expr const *side, Expr const *constant);

  llvm::SmallPtrSet<Expr const *, 32> conditions_;
};

} // namespace

void Conversions::decides(Expr const *condition) {
  if (!condition) return;
  if (auto const *full = dyn_cast<FullExpr>(condition)) condition = full->getSubExpr();
  while (auto const *parens = dyn_cast<ParenExpr>(condition)) condition = parens->getSubExpr();
  conditions_.insert(condition);
}

void Conversions::converted_number(ImplicitCastExpr const *cast) {
  bool const decides = conditions_.contains(cast);
  Expr const *from = cast->getSubExpr();
  QualType const to = cast->getType();
  if (auto const *first = conversion_by_class(from); first && reals_.is_real(from)) // two steps
    return wrap(from, Use::conversion, spelled(decides ? first->getType() : to));
  if (cast->isPartOfExplicitCast() || decides || !Reals::is_double(from->getType())) return;
  if (!reals_.is_real(from) && !gives_real_by_macro(from)) return;
  later([this, cast, from, to] {
    if (all_.settled.contains(cast)) return;
    if (to->isSpecificBuiltinType(BuiltinType::LongDouble)) // an operand, perhaps, with no context of its own
      return wrap(from, Use::conversion, spelled(to));
    convert(from, Use::conversion, reals_.keeps_integer(cast) ? "SYMREAL_REAL_INT(" + spelled(to) + ")" : spelled(to));
  });
}

void Conversions::implicit_cast(ImplicitCastExpr const *cast) {
  Expr const *from = cast->getSubExpr();
  if (cast->isTypeDependent() || from->isTypeDependent()) return;
  QualType const to = cast->getType();
  switch (cast->getCastKind()) {
  case CK_FloatingToIntegral:
  case CK_FloatingToBoolean:
  case CK_FloatingCast: converted_number(cast); return;
  case CK_BitCast: // to another type, or to one that is less const
  case CK_NoOp:
    if (!cast->isPartOfExplicitCast() && is_pointer_of_c(cast))
      later([this, cast, from] {
        if (!all_.settled.contains(cast)) convert(from, Use::cast, spelled(cast->getType()));
      });
    return;
  case CK_IntegralToFloating: // an enumerator among numbers: a class has no built-in promotion
    if (auto const *first = conversion_by_class(from); first && Reals::is_double(to) && !cast->isPartOfExplicitCast())
      return wrap(from, Use::conversion, spelled(first->getType())); // two steps, of which the language takes one
    if (Reals::is_double(to) && !cast->isPartOfExplicitCast() && is_enumeration(from))
      later([this, cast, from] {
        if (!all_.settled.contains(cast)) wrap(from->IgnoreImpCasts(), Use::conversion, spelled(counted_as(from)));
      });
    return;
  case CK_IntegralCast:
    if (!map_.language().CPlusPlus && to->isEnumeralType() && !cast->isPartOfExplicitCast() &&
        !from->IgnoreParens()->getType()->isEnumeralType() &&
        enumeration_of(from) != to->getAsTagDecl()->getCanonicalDecl())
      convert(from, Use::fit, {}); // a cast in numeric mode too would be folded otherwise
    return;
  default: return;
  }
}

// The operator is built in for double. Those of REAL are found if an operand is one; with further operators of the
// program a plain number would be ambiguous.
void Conversions::converted_operands(BinaryOperator const *operation) {
  Expr const *const left = operation->getLHS(), *const right = operation->getRHS();
  bool const is_known = !operation->isTypeDependent() && !left->isTypeDependent() && !right->isTypeDependent();
  if (!is_known || !map_.language().CPlusPlus || !Reals::is_double(left->getType()) ||
      !Reals::is_double(right->getType()) || operation->isAssignmentOp() || operation->isCommaOp())
    return;
  for (auto const &[operand, other] : {std::pair(left, right), std::pair(right, left)}) {
    bool const by_class = conversion_by_class(operand), is_real = reals_.is_real(operand);
    bool const is_plain = !by_class && !is_real && operand->IgnoreParenImpCasts()->getType()->isArithmeticType();
    if (by_class && is_real && (conversion_by_class(other) || !reals_.is_real(other)))
      wrap(operand, Use::conversion, spelled(operand->getType()));
    else if (is_plain && reals_.is_real(other) && !reals_.is_symbolic_integer(operand) &&
             has_operator(BinaryOperator::getOverloadedOperator(operation->getOpcode())))
      wrap(operand->IgnoreImpCasts(), Use::literal);
  }
}

void Conversions::converted_operand(UnaryOperator const *operation) {
  Expr const *const operand = operation->getSubExpr();
  if (!operation->isTypeDependent() && Reals::is_double(operand->getType()) && reals_.is_real(operand) &&
      conversion_by_class(operand))
    wrap(operand, Use::conversion, spelled(operand->getType()));
}

// 2.0i is of the library's class of doubles, which does not go with that of REALs.
void Conversions::complex_literal(UserDefinedLiteral const *literal) {
  if (literal->isTypeDependent() || reals_.in_roots(literal->getDirectCallee()) ||
      !map_.in_roots(literal->getBeginLoc()))
    return;
  if (auto const *type = dyn_cast_or_null<ClassTemplateSpecializationDecl>(literal->getType()->getAsCXXRecordDecl());
      is_std_class(type, "complex") && Reals::is_double(type->getTemplateArgs()[0].getAsType()))
    wrap(literal, Use::conversion, "::std::complex<" + std::string(reserved_type_name) + ">");
}

// Whether unqualified look-up finds an operator of the program of this kind.
bool Conversions::has_operator(OverloadedOperatorKind kind) const {
  DeclContext const *const from = at_.function ? at_.function->getDeclContext() : nullptr;
  DeclarationName const name = context_.DeclarationNames.getCXXOperatorName(kind);
  for (DeclContext const *at = from ? from : context_.getTranslationUnitDecl(); at; at = at->getParent()) {
    if (!at->isFileContext()) continue;
    for (NamedDecl const *one : at->lookup(name))
      if (map_.in_roots(one->getLocation())) return true;
  }
  return false;
}

// C converts pointers that C++ does not.
bool SyntaxHandler::is_pointer_of_c(ImplicitCastExpr const *cast) const {
  QualType const from = cast->getSubExpr()->getType()->getPointeeType(), to = cast->getType()->getPointeeType();
  if (map_.language().CPlusPlus || from.isNull() || to.isNull() || !cast->getType()->isPointerType()) return false;
  if (from->isFunctionType() != to->isFunctionType()) return true;
  if (!to.isAtLeastAsQualifiedAs(from)) return true;
  return !to->isVoidType() && !context_.hasSameUnqualifiedType(from, to);
}

void Conversions::compound_assignment(CompoundAssignOperator const *assignment) {
  Expr const *left = assignment->getLHS();
  if (assignment->isTypeDependent()) return;
  if (!map_.language().CPlusPlus && left->getType()->isEnumeralType()) wrap(left, Use::enumeration);
  if (assignment->getComputationResultType()->isSpecificBuiltinType(BuiltinType::LongDouble) && reals_.is_real(left))
    report(DiagnosticId::long_double, assignment->getOperatorLoc(),
           "a REAL is changed by what is computed in long double");
  if (Reals::is_double(left->getType())) return;
  if (!left->getType()->isArithmeticType() || !Reals::is_double(assignment->getComputationResultType())) return;
  if (!reals_.is_real(assignment->getRHS()) && reals_.stays_double(assignment->getRHS())) return;
  // The runtime has an operator with the original's effect. It takes a reference.
  if (reals_.is_symbolic_integer(left)) return; // its class has one
  if (!ScalarState::has_address(left))
    report(DiagnosticId::implicit_narrowing, assignment->getOperatorLoc(),
           "the result is a REAL and is converted to " + left->getType().getAsString());
  else if (std::optional<Span> const span = map_.token(assignment->getOperatorLoc());
           span && left->getType()->isIntegerType())
    facts_.conversions.insert({*span, left->getType().getUnqualifiedType().getAsString(map_.language()), true});
}

// constexpr double k = half(2.): the variable stays double, unlike the result of the rewritten function.
void Conversions::constant_initializer(Expr const *initializer) {
  if (!initializer || initializer->isTypeDependent()) return;
  if (auto const *list = dyn_cast<InitListExpr>(initializer->IgnoreImplicit())) {
    for (Expr const *element : list->inits()) constant_initializer(element);
    return;
  }
  if (auto const *cast = dyn_cast<ImplicitCastExpr>(initializer); cast && cast->getCastKind() != CK_LValueToRValue)
    return constant_initializer(cast->getSubExpr());
  if (Reals::is_double(initializer->getType()) && (reals_.is_real(initializer) || gives_real_by_macro(initializer)))
    wrap(initializer, Use::value);
}

void Conversions::conversion(CastExpr const *cast) {
  Expr const *from = cast->getSubExpr();
  bool const to_integer = cast->getCastKind() == CK_FloatingToIntegral;
  if ((!to_integer && cast->getCastKind() != CK_FloatingCast) || cast->isTypeDependent() || !reals_.is_real(from))
    return;
  later([this, cast, from, to_integer] {
    std::optional<Span> const span = map_.range(from->getSourceRange());
    if (span && !all_.settled.contains(cast))
      facts_.conversions.insert({*span, cast->getType().getUnqualifiedType().getAsString(map_.language()), to_integer});
  });
}

// x == 0.L: the same as in double where the constant is a double.
bool Conversions::compares_exactly(Expr const *side, Expr const *constant) {
  auto const *cast = dyn_cast<ImplicitCastExpr>(side->IgnoreParens());
  if (!cast || !cast->getType()->isSpecificBuiltinType(BuiltinType::LongDouble)) return false;
  llvm::APFloat value(0.);
  if (!reals_.is_real(cast->getSubExpr()) || !constant->EvaluateAsFloat(value, context_)) return false;
  bool is_rounded = false;
  value.convert(llvm::APFloat::IEEEdouble(), llvm::APFloat::rmNearestTiesToEven, &is_rounded);
  if (is_rounded) return false;
  all_.settled.insert(cast);
  wrap(constant->IgnoreImpCasts(), Use::literal);
  return true;
}

void Conversions::comparison(BinaryOperator const *comparison) {
  if (!comparison->isComparisonOp() || comparison->isTypeDependent()) return;
  Expr const *left = comparison->getLHS(), *right = comparison->getRHS();
  for (Expr const *side : {left, right})
    if (auto const *cast = dyn_cast<ImplicitCastExpr>(side); cast && cast->getType()->isPointerType()) {
      all_.settled.insert(cast);
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

void add_conversions(SyntaxTable &table) { table.add<Conversions>(); }

} // namespace symreal::rewrite
