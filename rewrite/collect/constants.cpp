// Objects of doubles that are constant expressions, such as constexpr std::array<double, 2>: they stay as they are, and
// whoever takes one whole takes an object of REALs.
#include "rewrite/collect/handlers.h"
#include "rewrite/model/library.h"
#include "rewrite/source/walk.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

// Whether the type spells double itself. A class of the program is rewritten within, and is the same for constants.
bool spells_double(QualType type, int depth = 0) {
  type = type.getNonReferenceType().getCanonicalType();
  if (type->isDependentType()) return false;
  if (auto const *array = type->getAsArrayTypeUnsafe())
    return Reals::is_double(array->getElementType()) || spells_double(array->getElementType(), depth + 1);
  if (type->isPointerType())
    return !type->isFunctionPointerType() && type->getPointeeType().isConstQualified() &&
           (Reals::is_double(type->getPointeeType()) || spells_double(type->getPointeeType(), depth + 1));
  auto const *record = dyn_cast_or_null<ClassTemplateSpecializationDecl>(type->getAsCXXRecordDecl());
  if (!record || Reals::is_passive_template(record)) return false;
  if (depth == 0 && is_std_class(record, "complex")) return false; // which converts
  for (TemplateArgument const &argument : record->getTemplateArgs().asArray())
    if (argument.getKind() == TemplateArgument::Type &&
        ((Reals::is_double(argument.getAsType()) && !argument.getAsType()->isReferenceType()) ||
         spells_double(argument.getAsType(), depth + 1)))
      return true;
  return false;
}

Expr const *bare(Expr const *expression) {
  while (true) {
    Expr const *inner = expression->IgnoreParenImpCasts();
    if (auto const *full = dyn_cast<FullExpr>(inner)) inner = full->getSubExpr();
    if (auto const *temporary = dyn_cast<MaterializeTemporaryExpr>(inner)) inner = temporary->getSubExpr();
    auto const *copy = dyn_cast<CXXConstructExpr>(inner);
    bool const is_written = !copy || isa<CXXTemporaryObjectExpr>(copy) || copy->getParenOrBraceRange().isValid();
    if (!is_written && copy->getConstructor()->isCopyOrMoveConstructor()) inner = copy->getArg(0);
    if (inner == expression) return inner;
    expression = inner;
  }
}

// Whether the expression is a constant object, a part of one, or a pointer into one.
bool names_constant(Expr const *expression, Reals const &reals) {
  expression = bare(expression);
  auto const is_constant = [&](ValueDecl const *declaration) {
    auto const *variable = dyn_cast<VarDecl>(declaration);
    return variable && variable->isConstexpr() && reals.in_roots(variable);
  };
  if (auto const *name = dyn_cast<DeclRefExpr>(expression)) return is_constant(name->getDecl());
  if (auto const *member = dyn_cast<MemberExpr>(expression))
    return is_constant(member->getMemberDecl()) ||
           (isa<FieldDecl>(member->getMemberDecl()) && names_constant(member->getBase(), reals));
  if (auto const *element = dyn_cast<ArraySubscriptExpr>(expression)) return names_constant(element->getBase(), reals);
  if (auto const *unary = dyn_cast<UnaryOperator>(expression))
    return (unary->getOpcode() == UO_AddrOf || unary->getOpcode() == UO_Deref) &&
           names_constant(unary->getSubExpr(), reals);
  if (auto const *binary = dyn_cast<BinaryOperator>(expression))
    return binary->isAdditiveOp() && binary->getType()->isPointerType() &&
           (names_constant(binary->getLHS(), reals) || names_constant(binary->getRHS(), reals));
  if (auto const *element = dyn_cast<CXXOperatorCallExpr>(expression))
    return element->getOperator() == OO_Subscript && !element->isTypeDependent() && element->getDirectCallee() &&
           !reals.in_roots(element->getDirectCallee()) && names_constant(element->getArg(0), reals);
  auto const *call = dyn_cast<CXXMemberCallExpr>(expression);
  return call && call->getMethodDecl() && !reals.in_roots(call->getMethodDecl()) &&
         names_constant(call->getImplicitObjectArgument(), reals);
}

// The name of the object of which such an expression names a part.
Expr const *object_name(Expr const *expression) {
  expression = bare(expression);
  ValueDecl const *declaration = nullptr;
  if (auto const *name = dyn_cast<DeclRefExpr>(expression)) declaration = name->getDecl();
  auto const *member = dyn_cast<MemberExpr>(expression);
  if (member && isa<VarDecl>(member->getMemberDecl()) && member->isImplicitAccess())
    declaration = member->getMemberDecl();
  if (declaration) return expression;
  if (member) return object_name(member->getBase());
  if (auto const *element = dyn_cast<ArraySubscriptExpr>(expression)) return object_name(element->getBase());
  if (auto const *unary = dyn_cast<UnaryOperator>(expression)) return object_name(unary->getSubExpr());
  if (auto const *binary = dyn_cast<BinaryOperator>(expression))
    return object_name(binary->getLHS()->getType()->isIntegerType() ? binary->getRHS() : binary->getLHS());
  if (auto const *element = dyn_cast<CXXOperatorCallExpr>(expression)) return object_name(element->getArg(0));
  auto const *call = dyn_cast<CXXMemberCallExpr>(expression);
  return call ? object_name(call->getImplicitObjectArgument()) : nullptr;
}

// A compiler evaluates such a function itself, where the bytes of an object have one type.
bool is_evaluated(FunctionDecl const *function) {
  auto const *method = dyn_cast_or_null<CXXMethodDecl>(function);
  return function && function->isConstexpr() && !(method && method->getParent()->isLambda());
}

class ConstantObjects : public SyntaxHandler {
public:
  explicit ConstantObjects(SyntaxTable &table) : SyntaxHandler(table) {
    on<CallSite>(ANYWHERE, &ConstantObjects::constants_handed);
    on<CallSite>(NUMBERS, &ConstantObjects::constant_arguments);
    on<CallExpr>(NUMBERS, &ConstantObjects::dependent_call);
    on<CXXConstructExpr>(NUMBERS, &ConstantObjects::copy);
    on<InitListExpr>(NUMBERS, &ConstantObjects::elements);
    on<FunctionDecl>(NUMBERS, &ConstantObjects::initializers);
    on<VarDecl>(ANYWHERE, &ConstantObjects::constant_results_of);
    on<VarDecl>(NUMBERS, &ConstantObjects::constant_initializer_of);
    on<CXXForRangeStmt>(NUMBERS, &ConstantObjects::constant_elements);
    on<ReturnStmt>(NUMBERS, &ConstantObjects::constant_result);
    on<BinaryOperator>(NUMBERS, &ConstantObjects::constant_operand);
  }

private:
  bool is_constant_evaluated() const { return at_.passive || at_.is_template_value || is_evaluated(at_.function); }
  void constants_handed(CallSite const *site);
  void constant_arguments(CallSite const *site);
  void dependent_call(CallExpr const *dependent);
  void copy(CXXConstructExpr const *construction) {
    if (construction->getConstructor()->isCopyOrMoveConstructor()) constant_object(construction->getArg(0));
  }
  void initializers(FunctionDecl const *function);
  void elements(InitListExpr const *list) {
    for (Expr const *element : converted_elements(list)) constant_object(element);
  }
  void constant_results_of(VarDecl const *variable) {
    if (at_.passive == constant_variable || at_.passive == static_member)
      constant_results(variable->getInit(), variable->getType()->getContainedAutoType());
  }
  void constant_results(Expr const *initializer, bool is_deduced);
  void constant_initializer_of(VarDecl const *variable);
  void constant_elements(CXXForRangeStmt const *loop);
  void constant_result(ReturnStmt const *statement);
  void constant_operand(BinaryOperator const *operation);

  void constant_object(Expr const *value);
  void constant_object(Expr const *value, Use use);
};

} // namespace

void ConstantObjects::constant_object(Expr const *value) {
  if (!at_.is_template_value && !is_evaluated(at_.function)) constant_object(value, Use::deduced);
}

void ConstantObjects::constant_object(Expr const *value, Use use) {
  if (!value || !map_.language().CPlusPlus) return;
  Expr const *object = bare(value);
  if (auto const *choice = dyn_cast<ConditionalOperator>(object)) {
    constant_object(choice->getTrueExpr(), use);
    return constant_object(choice->getFalseExpr(), use);
  }
  if (auto const *list = dyn_cast<ParenListExpr>(object)) { // in a template
    for (unsigned i = 0; i < list->getNumExprs(); ++i) constant_object(list->getExpr(i), use);
    return;
  }
  if (object->getType().isNull() || object->isTypeDependent() || !map_.in_roots(object->getBeginLoc())) return;
  if (!spells_double(object->getType()) || !names_constant(object, reals_)) return;
  Expr const *wrapped = use == Use::constant ? object_name(object) : object;
  if (!wrapped) return;
  auto const *name = dyn_cast<DeclRefExpr>(wrapped);
  bool const is_local = name && cast<VarDecl>(name->getDecl())->hasLocalStorage();
  wrap(wrapped, is_local && use == Use::constant ? Use::local_constant : use);
}

// An object that is handed, where the compiler evaluates, to a function of the program that takes REALs.
void ConstantObjects::constants_handed(CallSite const *site) {
  if (!is_constant_evaluated() || !reals_.in_roots(site->function)) return;
  FunctionDecl const *written = Reals::pattern(site->function);
  for (std::size_t i = 0; i < site->arguments.size() && i < written->getNumParams(); ++i)
    if (!written->getParamDecl(static_cast<unsigned>(i))->getType()->isDependentType())
      constant_object(site->arguments[i], Use::constant);
}

// constexpr std::array<double, 2> doubled = scaled(pair, 2);
void ConstantObjects::constant_results(Expr const *initializer, bool is_deduced) {
  if (!initializer || initializer->isTypeDependent()) return;
  if (auto const *list = dyn_cast<InitListExpr>(initializer->IgnoreImplicit())) {
    for (Expr const *element : list->inits()) constant_results(element, false);
    return;
  }
  auto const *call = dyn_cast<CallExpr>(bare(initializer));
  FunctionDecl const *function = call ? call->getDirectCallee() : nullptr;
  if (is_deduced || !function || !reals_.in_roots(function) || !call->getType()->isRecordType()) return;
  if (spells_double(call->getType()) && !Reals::pattern(function)->getReturnType()->isDependentType())
    wrap(call, Use::plain_object);
}

void ConstantObjects::constant_arguments(CallSite const *site) {
  auto const &[expression, place, function, arguments, overloaded] = *site;
  if (is_constant_evaluated() || !takes_as_declared(function, reals_)) return;
  bool const outside = is_outside(function, map_, reals_);
  bool const is_deduced = outside && function->getPrimaryTemplate();
  auto const is_constant = [this](Expr const *one) { return names_constant(one, reals_); };
  // A library's template takes either; a class of numbers and the operands of an operator must agree.
  auto const *constructor = dyn_cast<CXXConstructorDecl>(function);
  bool const is_of_numbers = constructor && reals_.mentions_real(context_.getRecordType(constructor->getParent()));
  bool const is_mixed = function->isOverloadedOperator() && !llvm::all_of(arguments, is_constant);
  bool const is_range = arguments.size() > 1 && !llvm::all_of(arguments, is_constant);
  if (is_deduced && !is_mixed && (!is_of_numbers || is_range)) return;
  for (std::size_t i = 0; i < arguments.size() && i < function->getNumParams(); ++i) constant_object(arguments[i]);
}

// A call in a template, of functions of the program alone.
void ConstantObjects::dependent_call(CallExpr const *dependent) {
  auto const *names = dyn_cast<OverloadExpr>(dependent->getCallee()->IgnoreParenImpCasts());
  if (!names || dependent->getDirectCallee() || names->getNumDecls() == 0) return;
  bool const is_own = llvm::all_of(names->decls(), [this](NamedDecl const *one) { return reals_.in_roots(one); });
  for (Expr const *argument : dependent->arguments())
    if (is_own) constant_object(argument);
}

void ConstantObjects::constant_initializer_of(VarDecl const *variable) {
  Expr const *initializer = variable->getInit();
  if (!initializer || variable->isConstexpr() || variable->isCXXForRangeDecl()) return;
  bool const is_deduced = variable->getType()->getContainedAutoType();
  if (!is_deduced || !variable->getType()->isPointerType()) constant_object(initializer);
}

void ConstantObjects::constant_elements(CXXForRangeStmt const *loop) {
  VarDecl const *variable = loop->getLoopVariable();
  if (variable && variable->getType()->getContainedAutoType()) constant_object(loop->getRangeInit());
}

void ConstantObjects::constant_result(ReturnStmt const *statement) {
  if (!at_.function) return;
  QualType const type = at_.function->getDeclaredReturnType();
  Expr const *value = statement->getRetValue();
  if (value && !(type->getContainedAutoType() && value->getType()->isPointerType())) constant_object(value);
}

// p = table, p != table + 3
void ConstantObjects::constant_operand(BinaryOperator const *operation) {
  Expr const *left = operation->getLHS(), *right = operation->getRHS();
  if (!left->getType()->isPointerType() || !right->getType()->isPointerType() || operation->isCommaOp()) return;
  bool const first = names_constant(left, reals_), second = names_constant(right, reals_);
  if (first != second) constant_object(first ? left : right);
}

void ConstantObjects::initializers(FunctionDecl const *function) {
  auto const *constructor = dyn_cast<CXXConstructorDecl>(function);
  if (!constructor || !function->doesThisDeclarationHaveABody()) return;
  for (CXXCtorInitializer const *initializer : constructor->inits())
    if (initializer->isWritten()) constant_object(initializer->getInit());
}

void add_constants(SyntaxTable &table) { table.add<ConstantObjects>(); }

} // namespace symreal::rewrite
