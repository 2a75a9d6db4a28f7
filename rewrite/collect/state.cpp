// Uses of objects that may outlive a kernel: single numbers, and the names of objects.
#include "rewrite/collect/handlers.h"
#include "rewrite/collect/objects.h"
#include "rewrite/model/library.h"
#include "rewrite/model/written_first.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

// A pointer may differ in the next call, even one to constants. Text is checked where it is read.
bool is_object_pointer(QualType type) { return type->isObjectPointerType() && !is_character(type->getPointeeType()); }

bool is_pointer(Expr const *expression) {
  QualType const type = expression->getType();
  return type->isPointerType() || type->isMemberPointerType();
}

// Names alone: may it be written a second time?
bool is_name(Expr const *expression) {
  expression = expression->IgnoreParenImpCasts();
  if (auto const *member = dyn_cast<MemberExpr>(expression)) return is_name(member->getBase());
  return isa<DeclRefExpr, CXXThisExpr>(expression);
}

// Whether the expression could name a number other than the function's own, as far as a template shows.
bool names_object(Expr const *expression) {
  if (auto const *reference = dyn_cast<DeclRefExpr>(expression))
    return isa<VarDecl>(reference->getDecl()) && reference->getDecl()->getType()->isReferenceType();
  if (auto const *unary = dyn_cast<UnaryOperator>(expression)) return unary->getOpcode() == UO_Deref;
  return isa<MemberExpr>(expression) || isa<CXXDependentScopeMemberExpr>(expression) ||
         isa<ArraySubscriptExpr>(expression);
}

// Values that are used, and those that objects get.
class UsedObjects : public Loads {
public:
  explicit UsedObjects(SyntaxTable &table) : Loads(table) {
    on<CXXTypeidExpr>(RUNNING, &UsedObjects::class_asked);
    on<CXXDynamicCastExpr>(RUNNING, &UsedObjects::class_asked);
    on<BinaryOperator>(RUNNING, &UsedObjects::assignment);
    on<BinaryOperator>(RUNNING, &UsedObjects::related_pointers);
    on<UnaryOperator>(RUNNING, &UsedObjects::step);
    on<MemberExpr>(RUNNING, &UsedObjects::reference_member);
    on<CXXForRangeStmt>(RUNNING, &UsedObjects::copied_elements);
  }

private:
  // Uses that depend on an object's class: typeid(*p), dynamic_cast<T *>(p).
  void class_asked(CXXTypeidExpr const *type) {
    if (!type->isTypeOperand()) decides_by_pointer(type->getExprOperand());
  }
  void class_asked(CXXDynamicCastExpr const *cast) {
    if (!cast->isTypeDependent()) decides_by_pointer(cast->getSubExpr());
  }

  void reference_member(MemberExpr const *member) {
    auto const *field = dyn_cast<FieldDecl>(member->getMemberDecl());
    if (!field || !field->getType()->isReferenceType()) return;
    Expr const *base = member->getBase()->IgnoreParenImpCasts();
    if (!member->isArrow() && storage_.home(base) != Home::elsewhere) return;
    if (member->isImplicitAccess()) return wrap(member, Use::refers, "this");
    std::optional<Span> const written = map_.range(base->getSourceRange());
    if (!written || !is_name(base)) return;
    std::string const name = map_.text(*written, base->getBeginLoc());
    wrap(member, Use::refers, member->isArrow() ? name : "__builtin_addressof(" + name + ")");
  }

  // An lvalue whose value is used.
  void read(Expr const *value) override {
    if (Expr const *table = reals_.table_of(value))
      object(table, Use::read); // any of its elements
    else if (value->isGLValue() && Reals::is_double(value->getType())) {
      if (reals_.is_real(value) && may_outlive(value)) note(value, Use::read);
    } else if (value->isGLValue() && (ScalarState::is_scalar(value->getType()) || is_object_pointer(value->getType())))
      scalar(value, Use::read);
    else
      object(value, Use::read);
  }

  void assignment(BinaryOperator const *assignment) {
    Expr const *left = assignment->getLHS()->IgnoreParens();
    if (!assignment->isAssignmentOp() || assignment->isTypeDependent() || left->isTypeDependent()) return;
    Use const use = assignment->isCompoundAssignmentOp() ? Use::read : Use::written;
    if (ScalarState::is_scalar(left->getType()))
      scalar(left, use);
    else if (is_pointer(left))
      pointer(left);
    else if (!Reals::is_double(left->getType()))
      object(left, use);
    else if (reals_.is_real(left) && may_outlive(left))
      note(left, use);
  }

  void step(UnaryOperator const *step) {
    Expr const *operand = step->getSubExpr()->IgnoreParens();
    if (!step->isIncrementDecrementOp() || operand->isTypeDependent()) return;
    if (ScalarState::is_scalar(operand->getType()))
      scalar(operand, Use::read);
    else if (is_pointer(operand))
      pointer(operand);
    else if (Reals::is_double(operand->getType()) && may_outlive(operand))
      note(operand, Use::read);
  }

  // The relative position of two pointers depends on both. Tests for null are checked where the pointer is read.
  void related_pointers(BinaryOperator const *operation) {
    if (operation->isTypeDependent() || (operation->getOpcode() != BO_Sub && !operation->isComparisonOp())) return;
    Expr const *const sides[] = {operation->getLHS(), operation->getRHS()};
    for (Expr const *side : sides)
      if (!side->getType()->isObjectPointerType() ||
          side->isNullPointerConstant(context_, Expr::NPC_ValueDependentIsNotNull))
        return;
    for (Expr const *side : sides)
      if (Expr const *pointer = side->IgnoreParenImpCasts();
          pointer->getType()->isPointerType() && ScalarState::has_address(pointer))
        decides(pointer);
  }

  // Notes the implicit copies of elements in `for (double x : list)`.
  void copied_elements(CXXForRangeStmt const *loop) {
    Expr const *range = spelled_expression(loop->getRangeInit());
    if (range->isTypeDependent() || !range->isGLValue()) return;
    auto const *name = dyn_cast_or_null<DeclRefExpr>(Storage::base(range));
    auto const *variable = name ? dyn_cast<VarDecl>(name->getDecl()) : nullptr;
    if (variable && variable->hasGlobalStorage() && !variable->isConstexpr() && may_outlive(range))
      wrap(range, Use::at_run);
    auto const *record = range->getType()->getAsCXXRecordDecl();
    if (record && record->isInStdNamespace() && record->getName() != "array" && !is_string(range->getType()))
      decides(range);
    QualType const type = loop->getLoopVariable()->getType();
    if (type->isDependentType() || type->isReferenceType() || !holds_state(type)) return;
    if (Storage::lends(range->getType()))
      note(range, Use::read); // the elements lie elsewhere
    else
      object(range, Use::read);
  }
};

// The same in templates, which leave types open.
class DependentUses : public ObjectUses {
public:
  explicit DependentUses(SyntaxTable &table) : ObjectUses(table) {
    on<BinaryOperator>(RUNNING, &DependentUses::dependent_operands);
    on<CallExpr>(RUNNING, &DependentUses::dependent_call);
    on<ReturnStmt>(NUMBERS, &DependentUses::result);
    on<VarDecl>(RUNNING, &DependentUses::initializer);
    on<ImplicitCastExpr>(INSTANCES, &DependentUses::instantiated_read);
  }

private:
  void result(ReturnStmt const *statement) {
    if (at_.function && depends(at_.function->getReturnType())) dependent_value(statement->getRetValue());
  }
  void initializer(VarDecl const *variable) {
    if (depends(variable->getType())) dependent_value(variable->getInit());
  }

  // A template leaves the types open, and with them most of the conversions that show a use. An operand of an
  // arithmetic operator counts as a use; the macro passes other types on.
  void dependent_operands(BinaryOperator const *operation) {
    if (!operation->isTypeDependent() ||
        (!operation->isAdditiveOp() && !operation->isMultiplicativeOp() && !operation->isAssignmentOp()))
      return;
    Expr const *left = operation->getLHS()->IgnoreParens(), *right = operation->getRHS()->IgnoreParens();
    if (names_object(right)) note(right, Use::read);
    if (operation->getOpcode() == BO_Assign ? names_object(left) || isa<CallExpr>(left) : names_object(left))
      note(left, operation->getOpcode() == BO_Assign ? Use::written : Use::read);
  }

  // A value that the template leaves open: Limits<T>::low, limit<T>, limit_of<T>(), or the argument of the template
  // itself.
  void instantiated_read(ImplicitCastExpr const *cast) {
    if (cast->getCastKind() != CK_LValueToRValue) return;
    Expr const *value = cast->getSubExpr()->IgnoreParens();
    Expr const *named = value;
    if (auto const *argument = dyn_cast<SubstNonTypeTemplateParmExpr>(value)) named = argument->getReplacement();
    ValueDecl const *declaration = nullptr;
    if (auto const *reference = dyn_cast<DeclRefExpr>(named)) declaration = reference->getDecl();
    if (auto const *member = dyn_cast<MemberExpr>(named)) declaration = member->getMemberDecl();
    auto const *variable = dyn_cast_or_null<VarDecl>(declaration);
    auto const *call = dyn_cast<CallExpr>(named);
    bool const is_given = call && !isa<CXXOperatorCallExpr>(call) && call->getDirectCallee() &&
                          reals_.in_roots(Reals::pattern(call->getDirectCallee()));
    if (((variable && variable->hasGlobalStorage()) || is_given) && may_outlive(named)) note(value, Use::read);
  }

  void dependent_value(Expr const *value) {
    if (!value) return;
    if (auto const *list = dyn_cast<ParenListExpr>(value); list && list->getNumExprs() == 1) value = list->getExpr(0);
    if (names_object(value->IgnoreParens())) note(value->IgnoreParens(), Use::read);
  }

  void dependent_call(CallExpr const *call) {
    // stream.operator<<(x): the operator for REALs is a free function.
    if (auto const *member = dyn_cast<UnresolvedMemberExpr>(call->getCallee()->IgnoreParenImpCasts()))
      if (member->getMemberName().getCXXOverloadedOperator() == OO_LessLess && call->getNumArgs() == 1 &&
          member->getNamingClass()->isInStdNamespace() && call->getArg(0)->isTypeDependent())
        wrap_for(call->getRParenLoc(), call->getArg(0), Use::value);
    auto const *callee = dyn_cast<UnresolvedLookupExpr>(call->getCallee()->IgnoreParenImpCasts());
    if (!callee || !callee->getName().isIdentifier()) return;
    if (!Reals::is_math_name(callee->getName().getAsIdentifierInfo()->getName())) return;
    for (Expr const *argument : call->arguments())
      if (names_object(argument->IgnoreParens())) note(argument->IgnoreParens(), Use::read);
  }

  // A value whose type is not known yet.
  static bool depends(QualType type) { return type->isDependentType() && !type->isReferenceType(); }
};

// Names of static objects, and members of classes.
class StaticObjects : public ObjectUses {
public:
  explicit StaticObjects(SyntaxTable &table) : ObjectUses(table) {
    on<DeclRefExpr>(RUNNING, &StaticObjects::name);
    on<MemberExpr>(RUNNING, &StaticObjects::name);
    on<RecordDecl>(ANYWHERE, &StaticObjects::members);
  }

private:
  void name(DeclRefExpr const *reference) { name(reference, reference->getDecl()); }
  void name(MemberExpr const *member) { name(member, member->getMemberDecl()); }

  void name(Expr const *reference, ValueDecl const *named) {
    auto const *variable = dyn_cast<VarDecl>(named);
    if (!variable || !variable->hasGlobalStorage() || reals_.is_passive(variable) ||
        variable->getType()->isReferenceType())
      return;
    if (variable->getType()->isDependentType() || !holds_state(variable->getType())) return;
    if (context_.getBaseElementType(variable->getType()).isConstQualified()) return;
    bool const of_numbers = reals_.carries_real(variable->getType());
    if (!of_numbers && scalars_.is_fixed(variable)) return;
    Use use = Use::state;
    if (variable->isStaticLocal() && !of_numbers)
      use = written_first_.holds(variable)       ? Use::scratch_state
            : written_first_.is_likely(variable) ? Use::local_state
                                                 : Use::state;
    wrap(reference, use, to_string(map_.place(variable->getCanonicalDecl()->getLocation())));
    // A mention with a dependent type counts as a use.
    if (at_.in_template)
      later([this, reference] {
        if (!all_.judged.contains(reference)) note(reference, Use::read);
      });
  }

  // Makes the class enumerate its members, private ones included, so that the runtime can visit a whole object.
  void members(RecordDecl const *record) {
    if (!record->isThisDeclarationADefinition() || record->isImplicit() || record->isUnion() || record->isLambda())
      return;
    if (!record->getIdentifier() || record->isAnonymousStructOrUnion() || !map_.in_roots(record->getLocation())) return;
    if (isa<ClassTemplateSpecializationDecl>(record) &&
        !cast<ClassTemplateSpecializationDecl>(record)->isExplicitSpecialization() &&
        !isa<ClassTemplatePartialSpecializationDecl>(record))
      return;
    ClassFact fact{record->isClass() ? "private" : "public"};
    if (auto const *derived = dyn_cast<CXXRecordDecl>(record))
      for (CXXBaseSpecifier const &base : derived->bases()) {
        std::optional<Span> const span = map_.range(base.getTypeSourceInfo()->getTypeLoc().getSourceRange());
        if (span) fact.bases.push_back({*span, base.getType()->isDependentType() || holds_state(base.getType())});
      }
    for (FieldDecl const *field : record->fields()) {
      QualType const type = field->getType();
      if (!field->getIdentifier()) continue;
      if (field->isBitField()) { // which has no address
        fact.fields.push_back({"", true});
        continue;
      }
      bool const is_looked_at = !type->isIncompleteType() && !type->isReferenceType() && !type->isPointerType() &&
                                (!ScalarState::is_scalar(type) || ScalarState::has_address(field));
      bool const holds = is_looked_at && (type->isDependentType() || holds_state(type));
      fact.fields.push_back({field->getNameAsString(), holds});
    }
    std::optional<Span> const brace = map_.token(record->getBraceRange().getBegin());
    if (!brace || record->getBraceRange().getBegin().isMacroID()) return;
    facts_.members.try_emplace(*brace, std::move(fact));
  }

  WrittenFirst written_first_;
};

} // namespace

void add_state(SyntaxTable &table) {
  table.add<UsedObjects>();
  table.add<DependentUses>();
  table.add<StaticObjects>();
}

} // namespace symreal::rewrite
