// Uses of objects that may outlive a kernel: single numbers, and the names of objects.
#include "rewrite/collect/collector.h"
#include "rewrite/model/library.h"
#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
using namespace clang;

// Whether the token comes from the body of a macro that is defined outside the roots.
static bool is_library_macro(SourceLocation location, SourceMap const &map) {
  SourceManager const &sources = map.sources();
  if (!sources.isMacroBodyExpansion(location)) return false;
  SourceLocation const spelled = sources.getSpellingLoc(location);
  return sources.getFileEntryRefForID(sources.getFileID(spelled)) && !map.in_roots(spelled);
}

std::string Collector::short_text(Span const &span, SourceLocation at) const {
  constexpr std::size_t longest = 60;
  std::string text = normalised(map_.text(span, at));
  if (text.size() > longest) text.replace(longest, std::string::npos, "...");
  return text;
}

// Wraps the expression in a macro that reports its name and place.
void Collector::note(Expr const *expression, Use use, Expr const *named, std::string const &words) {
  SourceLocation const begin = expression->getBeginLoc();
  if (!map_.in_roots(begin)) return;
  // Whether the bytes of a scalar are also those of a number is another question.
  Expr const *base = Storage::base(expression);
  if (base && (isa<DeclRefExpr>(base) || !ScalarState::is_scalar(expression->getType()))) judged_.insert(base);
  std::optional<Span> const span = map_.range(expression->getSourceRange());
  if (!span && is_library_macro(begin, map_)) return; // library code, as in a template
  if (!span) {
    report(DiagnosticId::split_expression, begin,
           "a macro makes a part of this expression: cannot tell whether it uses hidden state", Severity::warning);
    return;
  }
  if (!named) named = expression;
  std::string const name = short_text(map_.range(named->getSourceRange()).value_or(*span), begin);
  facts_.wraps.insert(
      {*span, use, words + in_quotes(name) + ", " + in_quotes(to_string(map_.place(named->getBeginLoc())))});
}

// Whether the expression is part of a variable whose scalars never change. The target of a pointer is not.
bool Collector::is_fixed(Expr const *expression) const {
  Expr const *part = spelled_expression(expression);
  while (!isa<DeclRefExpr>(part)) {
    auto const *member = dyn_cast<MemberExpr>(part);
    auto const *index = dyn_cast<ArraySubscriptExpr>(part);
    auto const *call = dyn_cast<CallExpr>(part);
    Expr const *whole = member  ? member->getBase()
                        : index ? index->getBase()
                        : call  ? Storage::object_of(call)
                                : nullptr;
    if (!whole || (member && (member->isArrow() || isa<VarDecl>(member->getMemberDecl())))) return false;
    part = spelled_expression(whole);
    QualType const type = part->getType();
    if (index && !type->isArrayType()) return false;
    if (type->isRecordType() && Storage::holds_pointer(type) && !Storage::owns_elements(type)) return false;
  }
  auto const *variable = dyn_cast<VarDecl>(cast<DeclRefExpr>(part)->getDecl());
  return variable && scalars_.is_fixed(variable);
}

// The value of a scalar is used, or it gets a new one.
void Collector::scalar(Expr const *expression, Use use) {
  if (expression->isTypeDependent() || !may_outlive(expression)) return;
  if (is_fixed(expression)) return;
  // A macro of a library, such as errno.
  SourceLocation const begin = expression->getBeginLoc();
  if (begin.isMacroID() && !map_.token(begin)) return;
  if (ScalarState::has_address(expression)) return note(expression, use);
  // Once for a member, however often it is used.
  auto const *member = dyn_cast<MemberExpr>(expression->IgnoreParens());
  bool const is_declared_here = member && map_.in_roots(member->getMemberDecl()->getLocation());
  std::optional<Span> const span = map_.range(expression->getSourceRange());
  std::string const name = member ? member->getMemberDecl()->getQualifiedNameAsString()
                           : span ? normalised(map_.text(*span, begin))
                                  : "this";
  report(DiagnosticId::scalar_not_looked_at, is_declared_here ? member->getMemberDecl()->getLocation() : begin,
         "cannot tell whether '" + name + "' is hidden state");
}

// A pointer may differ in the next call, even one to constants. Text is checked where it is read.
static bool is_object_pointer(QualType type) {
  return type->isObjectPointerType() && !is_character(type->getPointeeType());
}

static bool is_pointer(Expr const *expression) {
  QualType const type = expression->getType();
  return type->isPointerType() || type->isMemberPointerType();
}

void Collector::pointer(Expr const *expression) {
  if (may_outlive(expression) && ScalarState::has_address(expression)) note(expression, Use::written);
}

bool Collector::may_outlive(Expr const *expression) const {
  Home const home = storage_.home(expression);
  if (home != Home::local) return home == Home::elsewhere;
  auto const *base = dyn_cast_or_null<DeclRefExpr>(Storage::base(expression));
  auto const *variable = base ? dyn_cast<VarDecl>(base->getDecl()) : nullptr;
  return variable && surroundings_.contain(variable, base->getLocation());
}

// Names alone: may it be written a second time?
static bool is_name(Expr const *expression) {
  expression = expression->IgnoreParenImpCasts();
  if (auto const *member = dyn_cast<MemberExpr>(expression)) return is_name(member->getBase());
  return isa<DeclRefExpr, CXXThisExpr>(expression);
}

void Collector::reference_member(MemberExpr const *member) {
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
void Collector::read(Expr const *value) {
  value = value->IgnoreParens();
  if (auto const *choice = dyn_cast<ConditionalOperator>(value)) {
    read(choice->getTrueExpr());
    read(choice->getFalseExpr());
  } else if (auto const *comma = dyn_cast<BinaryOperator>(value)) {
    if (comma->isCommaOp()) read(comma->getRHS());
  } else if (isa<UnaryOperator>(value) && cast<UnaryOperator>(value)->isIncrementDecrementOp()) {
    // noted as a step
  } else if (Expr const *table = reals_.table_of(value)) {
    object(table, Use::read); // any of its elements
  } else if (value->isGLValue() && Reals::is_double(value->getType())) {
    number_of_union(value);
    if (reals_.is_real(value) && may_outlive(value)) note(value, Use::read);
  } else if (value->isGLValue() && (ScalarState::is_scalar(value->getType()) || is_object_pointer(value->getType())))
    scalar(value, Use::read);
  else
    object(value, Use::read);
}

void Collector::assignment(BinaryOperator const *assignment) {
  Expr const *left = assignment->getLHS()->IgnoreParens();
  if (assignment->isTypeDependent() || left->isTypeDependent()) return;
  Use const use = assignment->isCompoundAssignmentOp() ? Use::read : Use::written;
  store_to_view(left, use == Use::read);
  if (use == Use::written) store_to_union(left);
  if (use == Use::written) // the old contents of an overwritten union do not matter
    for (auto const *member = dyn_cast<MemberExpr>(left); member;
         member = dyn_cast<MemberExpr>(member->getBase()->IgnoreParenImpCasts()))
      judged_.insert(member);
  if (ScalarState::is_scalar(left->getType()))
    scalar(left, use);
  else if (is_pointer(left))
    pointer(left);
  else if (!Reals::is_double(left->getType()))
    object(left, use);
  else if (reals_.is_real(left) && may_outlive(left))
    note(left, use);
}

void Collector::step(UnaryOperator const *step) {
  Expr const *operand = step->getSubExpr()->IgnoreParens();
  if (operand->isTypeDependent()) return;
  store_to_view(operand, /*reads=*/true);
  if (ScalarState::is_scalar(operand->getType()))
    scalar(operand, Use::read);
  else if (is_pointer(operand))
    pointer(operand);
  else if (Reals::is_double(operand->getType()) && may_outlive(operand))
    note(operand, Use::read);
}

namespace {

// Whether the expression could name a number other than the function's own, as far as a template shows.
bool names_object(Expr const *expression) {
  if (auto const *reference = dyn_cast<DeclRefExpr>(expression))
    return isa<VarDecl>(reference->getDecl()) && reference->getDecl()->getType()->isReferenceType();
  if (auto const *unary = dyn_cast<UnaryOperator>(expression)) return unary->getOpcode() == UO_Deref;
  return isa<MemberExpr>(expression) || isa<CXXDependentScopeMemberExpr>(expression) ||
         isa<ArraySubscriptExpr>(expression);
}

} // namespace

// The relative position of two pointers depends on both. Tests for null are checked where the pointer is read.
void Collector::related_pointers(BinaryOperator const *operation) {
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

// A template leaves the types open, and with them most of the conversions that show a use. An operand of an arithmetic
// operator counts as a use; the macro passes other types on.
void Collector::dependent_operands(BinaryOperator const *operation) {
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
void Collector::instantiated_read(Expr const *value) {
  value = value->IgnoreParens();
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

void Collector::dependent_value(Expr const *value) {
  if (!value) return;
  if (auto const *list = dyn_cast<ParenListExpr>(value); list && list->getNumExprs() == 1) value = list->getExpr(0);
  if (names_object(value->IgnoreParens())) note(value->IgnoreParens(), Use::read);
}

void Collector::dependent_call(CallExpr const *call) {
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

// Notes the implicit copies of elements in `for (double x : list)`.
void Collector::copied_elements(CXXForRangeStmt const *loop) {
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

void Collector::state(VarDecl const *variable, Expr const *reference, bool is_dependent) {
  if (!variable->hasGlobalStorage() || reals_.is_passive(variable) || variable->getType()->isReferenceType()) return;
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
  if (is_dependent)
    later([this, reference] {
      if (!judged_.contains(reference)) note(reference, Use::read);
    });
}

// Makes the class enumerate its members, private ones included, so that the runtime can visit a whole object.
void Collector::members(RecordDecl const *record) {
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

} // namespace symreal::rewrite
