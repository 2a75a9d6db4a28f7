// Walk of one source's syntax tree that collects facts about the roots.
#include "rewrite/c/constructs.h"
#include "rewrite/collect/collector.h"
#include "rewrite/collect/walks.h"
#include "rewrite/model/context_walk.h"
#include "rewrite/model/surroundings.h"
#include "rewrite/pragma/configured.h"
#include "rewrite/pragma/externals.h"
#include "rewrite/pragma/function_pragmas.h"
#include "rewrite/pragma/pragma_items.h"
#include "rewrite/select/decisions.h"
#include "rewrite/unit/collect_source.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

class Visitor : public ContextWalk {

public:
  Visitor(ASTContext &context, SourceMap const &map, Reals const &reals, ScalarState const &scalars,
          Surroundings const &surroundings, PragmaIndex const &index, bool children_first, Facts &facts)
      : ContextWalk(map, reals),
        context_(context),
        scalars_(scalars),
        index_(index),
        children_first_(children_first),
        facts_(facts),
        collect_(context, map, reals, scalars, surroundings, facts) {
    collect_.set_function(&function_);
  }

  std::vector<FunctionDecl const *> definitions;

  bool TraverseDecltypeTypeLoc(DecltypeTypeLoc type) override {
    Within const unevaluated(no_state_, true);
    if (!passive_) collect_.deduced_elements(type.getUnderlyingExpr());
    collect_.looked_at(type.getUnderlyingExpr());
    return Walk::TraverseDecltypeTypeLoc(type);
  }
  bool VisitUnaryExprOrTypeTraitExpr(UnaryExprOrTypeTraitExpr *expression) override {
    if (expression->isArgumentType()) return true;
    collect_.looked_at(expression->getArgumentExpr()->IgnoreParens());
    collect_.c_type_asked(expression->getArgumentExpr(), expression->getKind() == UETT_SizeOf);
    return true;
  }
  bool VisitCXXTypeidExpr(CXXTypeidExpr *expression) override {
    if (!expression->isTypeOperand()) collect_.looked_at(expression->getExprOperand());
    if (!passive_) collect_.type_asked(expression);
    if (!passive_ && !no_state_ && !expression->isTypeOperand()) collect_.class_asked(expression->getExprOperand());
    return true;
  }
  bool VisitCXXDynamicCastExpr(CXXDynamicCastExpr *cast) override {
    if (!passive_ && !no_state_ && !cast->isTypeDependent()) collect_.class_asked(cast->getSubExpr());
    return true;
  }
  bool TraverseConceptExprRequirement(concepts::ExprRequirement *requirement) override {
    if (requirement->isCompound() && !requirement->isExprSubstitutionFailure())
      collect_.looked_at(requirement->getExpr());
    return Walk::TraverseConceptExprRequirement(requirement);
  }
  bool VisitAtomicExpr(AtomicExpr *call) override {
    if (!passive_ && map_.in_roots(call->getBeginLoc())) collect_.atomic_builtin(call);
    return true;
  }

  bool VisitBuiltinTypeLoc(BuiltinTypeLoc type) override {
    collect_.builtin_type(type, passive_);
    return true;
  }
  bool VisitComplexTypeLoc(ComplexTypeLoc type) override {
    collect_.complex_type(type);
    return true;
  }
  bool VisitElaboratedTypeLoc(ElaboratedTypeLoc type) override {
    NestedNameSpecifierLoc const qualifier = type.getQualifierLoc();
    bool const within_type = qualifier && qualifier.getNestedNameSpecifier()->getAsType();
    named_type(type.getNamedTypeLoc(), static_cast<bool>(qualifier), within_type);
    return true;
  }
  bool TraverseNestedNameSpecifierLoc(NestedNameSpecifierLoc name) override {
    if (name && name.getNestedNameSpecifier()->getAsType()) {
      NestedNameSpecifierLoc const prefix = name.getPrefix();
      bool const within_type = prefix && prefix.getNestedNameSpecifier()->getAsType();
      named_type(name.getTypeLoc(), static_cast<bool>(prefix), within_type);
    }
    return Walk::TraverseNestedNameSpecifierLoc(name);
  }

  bool VisitCallExpr(CallExpr *call) override {
    if (passive_) {
      std::vector<Expr const *> const all(call->arg_begin(), call->arg_end());
      bool const has_object = isa<CXXOperatorCallExpr>(call) && isa_and_nonnull<CXXMethodDecl>(call->getDirectCallee());
      collect_.constants_handed(call->getDirectCallee(), llvm::ArrayRef(all).drop_front(has_object));
    }
    if (passive_ || !map_.in_roots(call->getBeginLoc())) return true;
    collect_.call(call);
    collect_.constant_arguments(call);
    collect_.c_call(call);
    collect_.c_arguments(call);
    collect_.c_generic_call(call);
    collect_.kind_asked(call);
    collect_.c_search(call);
    collect_.dependent_variadic_call(call);
    if (no_state_) return true;
    collect_.environment_of_call(call);
    collect_.call_outside(call);
    collect_.text_of_call(call);
    collect_.state_of_call(call);
    collect_.dependent_call(call);
    return true;
  }
  bool VisitCXXThrowExpr(CXXThrowExpr *expression) override {
    if (!passive_ && expression->getSubExpr()) collect_.erased(expression->getSubExpr());
    return true;
  }
  bool VisitCXXConstructExpr(CXXConstructExpr *construction) override {
    if (passive_ && !construction->getConstructor()->isCopyOrMoveConstructor()) {
      std::vector<Expr const *> const all(construction->arg_begin(), construction->arg_end());
      collect_.constants_handed(construction->getConstructor(), all);
    }
    if (passive_ || !map_.in_roots(construction->getLocation())) return true;
    collect_.construction(construction);
    collect_.keeps_text(construction->getType());
    if (!no_state_) collect_.state_of_construction(construction);
    return true;
  }
  bool VisitCXXNewExpr(CXXNewExpr *made) override {
    if (!passive_ && !no_state_) collect_.made_in_place(made);
    return true;
  }
  bool VisitImplicitCastExpr(ImplicitCastExpr *cast) override {
    if (passive_) return true;
    if (Collector::may_convert(cast))
      collect_.later([this, cast] { collect_.implicit_cast(cast, decisions_.contains(cast)); });
    if (no_state_ || cast->isTypeDependent()) return true;
    if (cast->getCastKind() == CK_LValueToRValue) {
      collect_.read(cast->getSubExpr());
      collect_.read_view(cast->getSubExpr());
      collect_.error_read(cast->getSubExpr());
      collect_.characters(cast->getSubExpr());
    }
    collect_.pointer_cast(cast);
    return true;
  }
  // Its elements are walked as they were parsed; the conversions and copies that they become stand in the other form.
  bool VisitInitListExpr(InitListExpr *list) override {
    if (map_.in_roots(list->getBeginLoc())) collect_.designators(list);
    if (passive_) return true;
    InitListExpr const *complete = list->isSemanticForm() ? list : list->getSemanticForm();
    if (!complete || complete->isTypeDependent()) return true;
    for (Expr const *element : complete->inits()) collect_.constant_object(element);
    if (no_state_) return true;
    for (Expr const *element : complete->inits()) {
      if (!element) continue;
      if (auto const *cast = dyn_cast<ImplicitCastExpr>(element); cast && cast->getCastKind() == CK_LValueToRValue)
        collect_.read(cast->getSubExpr());
      else if (auto const *made = dyn_cast<CXXConstructExpr>(element->IgnoreImplicit())) {
        if (made->getParenOrBraceRange().isInvalid()) collect_.converting_construction(made);
        collect_.state_of_construction(made);
      }
    }
    return true;
  }
  bool VisitGCCAsmStmt(GCCAsmStmt *assembly) override {
    if (!passive_ && map_.in_roots(assembly->getBeginLoc())) collect_.assembly(assembly);
    return true;
  }
  bool VisitCXXForRangeStmt(CXXForRangeStmt *loop) override {
    if (!passive_) collect_.constant_elements(loop);
    if (!passive_ && !no_state_) {
      collect_.copied_elements(loop);
      collect_.characters_of(loop);
    }
    return true;
  }
  bool VisitRecordDecl(RecordDecl *record) override {
    collect_.members(record);
    return true;
  }
  bool VisitExplicitCastExpr(ExplicitCastExpr *cast) override {
    if (!passive_) collect_.explicit_cast(cast);
    if (!passive_ && !no_state_) collect_.pointer_cast(cast);
    return true;
  }
  bool VisitCastExpr(CastExpr *cast) override {
    if (!passive_) collect_.conversion(cast);
    return true;
  }
  bool VisitCompoundAssignOperator(CompoundAssignOperator *assignment) override {
    if (!passive_) collect_.compound_assignment(assignment);
    return true;
  }
  bool VisitConditionalOperator(ConditionalOperator *choice) override {
    decide(choice->getCond());
    if (!passive_) collect_.choice(choice);
    collect_.c_choice(choice);
    collect_.c_widths(choice);
    return true;
  }
  bool VisitAbstractConditionalOperator(AbstractConditionalOperator *choice) override {
    collect_.narrow_fields(choice);
    return true;
  }
  bool VisitReturnStmt(ReturnStmt *statement) override {
    if (!passive_ && function_) collect_.constant_result(statement, function_);
    if (!passive_ && function_ && depends(function_->getReturnType()))
      collect_.dependent_value(statement->getRetValue());
    return true;
  }
  bool VisitVarDecl(VarDecl *variable) override {
    if (passive_ == constant_variable || passive_ == static_member)
      collect_.constant_initializer(variable->getInit(), variable->getType()->getContainedAutoType());
    if (!passive_) collect_.deduced_variable(variable);
    if (!passive_) collect_.constant_initializer_of(variable);
    if (variable->hasInit() && variable->getType()->getContainedAutoType())
      collect_.c_type_asked(variable->getInit(), /*is_size=*/false);
    if (!passive_) collect_.named_variable(variable);
    if (!passive_ && !no_state_ && depends(variable->getType())) collect_.dependent_value(variable->getInit());
    return true;
  }
  bool VisitNamedDecl(NamedDecl *declaration) override {
    collect_.c_declaration(declaration);
    if (auto const *described = dyn_cast<TemplateDecl>(declaration))
      collect_.constrained(described->getTemplateParameters());
    if (auto const *object = dyn_cast<ValueDecl>(declaration)) collect_.keeps_text(object->getType());
    return true;
  }
  bool VisitCXXMemberCallExpr(CXXMemberCallExpr *call) override {
    if (!passive_) {
      collect_.removed_member(call);
      collect_.type_asked(call);
      if (!no_state_) collect_.stream_asked(call);
    }
    return true;
  }
  bool VisitUserDefinedLiteral(UserDefinedLiteral *literal) override {
    if (!passive_) collect_.complex_literal(literal);
    return true;
  }
  bool VisitLambdaExpr(LambdaExpr *lambda) override {
    collect_.argument_list(lambda->getCallOperator());
    if (!passive_ && !lambda->hasExplicitResultType()) collect_.deduced_return(lambda->getCallOperator());
    return true;
  }
  bool VisitFunctionDecl(FunctionDecl *function) override {
    for (unsigned i = 0; i < function->getNumTemplateParameterLists(); ++i)
      collect_.constrained(function->getTemplateParameterList(i));
    if (!function->doesThisDeclarationHaveABody()) return true;
    definitions.push_back(function);
    if (auto const *constructor = dyn_cast<CXXConstructorDecl>(function); constructor && !passive_)
      for (CXXCtorInitializer const *initializer : constructor->inits())
        if (initializer->isWritten()) collect_.constant_object(initializer->getInit());
    collect_.argument_list(function);
    if (!passive_ && function->getDeclaredReturnType()->getContainedAutoType()) collect_.deduced_return(function);
    return true;
  }
  bool VisitDeclRefExpr(DeclRefExpr *reference) override {
    if (auto const *variable = dyn_cast<VarDecl>(reference->getDecl())) state(variable, reference);
    if (!passive_) collect_.function_value(reference);
    if (!passive_) collect_.builtin(reference);
    return true;
  }
  bool VisitPredefinedExpr(PredefinedExpr *name) override {
    if (function_ && name->getIdentKind() == PredefinedIdentKind::PrettyFunction) collect_.printed_signature(function_);
    if (function_ && !passive_) collect_.signature_asked(name, function_);
    return true;
  }
  bool VisitMemberExpr(MemberExpr *member) override {
    if (auto const *variable = dyn_cast<VarDecl>(member->getMemberDecl())) state(variable, member);
    if (!passive_ && !no_state_) collect_.union_member(member);
    if (!passive_ && !no_state_) collect_.reference_member(member);
    return true;
  }
  bool VisitCompoundStmt(CompoundStmt *block) override {
    for (Stmt const *statement : block->body()) note_item(statement, context_, reals_, scalars_, index_, facts_);
    return true;
  }

  bool VisitCXXRewrittenBinaryOperator(CXXRewrittenBinaryOperator *comparison) override {
    if (!passive_ && !no_state_) collect_.text_comparison(comparison);
    return true;
  }

  // The value of an expression statement is unused.
  bool VisitStmt(Stmt *statement) override {
    collect_.discarded(statement, function_);
    return true;
  }

  // Conditions convert to bool by themselves: no cast is needed in front of the decision.
  bool VisitIfStmt(IfStmt *statement) override { return decide(statement->getCond()); }
  bool VisitWhileStmt(WhileStmt *statement) override { return decide(statement->getCond()); }
  bool VisitDoStmt(DoStmt *statement) override { return decide(statement->getCond()); }
  bool VisitForStmt(ForStmt *statement) override { return decide(statement->getCond()); }
  bool VisitTypeOfExprTypeLoc(TypeOfExprTypeLoc type) override {
    collect_.c_type_asked(type.getUnderlyingExpr(), /*is_size=*/false);
    return true;
  }
  bool VisitGenericSelectionExpr(GenericSelectionExpr *selection) override {
    if (selection->isExprPredicate()) collect_.c_control(selection->getControllingExpr());
    return true;
  }
  bool VisitIntegerLiteral(IntegerLiteral *literal) override {
    collect_.c_literal(literal);
    return true;
  }
  bool VisitUnaryOperator(UnaryOperator *unary) override {
    collect_.c_operation(unary);
    collect_.c_widths(unary);
    if (!passive_) collect_.converted_operand(unary);
    if (!passive_ && !no_state_ && unary->isIncrementDecrementOp()) collect_.step(unary);
    return unary->getOpcode() != UO_LNot || decide(unary->getSubExpr());
  }
  bool VisitBinaryOperator(BinaryOperator *binary) override {
    collect_.c_operation(binary);
    collect_.c_widths(binary);
    if (!passive_) collect_.narrow_fields(binary);
    if (!passive_) collect_.named_target(binary);
    if (!passive_) collect_.constant_operand(binary);
    if (!passive_) collect_.converted_operands(binary, function_ ? function_->getDeclContext() : nullptr);
    if (!passive_ && binary->isComparisonOp()) collect_.comparison(binary);
    if (!passive_ && !no_state_) {
      if (binary->isAssignmentOp()) {
        collect_.assignment(binary);
        collect_.error_assigned(binary);
      }
      collect_.related_pointers(binary);
      collect_.dependent_operands(binary);
    }
    return !binary->isLogicalOp() || (decide(binary->getLHS()) && decide(binary->getRHS()));
  }

  void finish() { collect_.finish(); }
  bool shouldTraversePostOrder() const override { return children_first_; }

private:
  void named_type(TypeLoc type, bool qualified, bool within_type) {
    if (passive_) return;
    if (auto const named = type.getAs<TypedefTypeLoc>())
      collect_.typedef_name(named.getTypedefNameDecl(), named.getNameLoc(), qualified, within_type);
    else if (auto const used = type.getAs<UsingTypeLoc>())
      collect_.typedef_name(dyn_cast<TypedefNameDecl>(used.getFoundDecl()->getTargetDecl()), used.getNameLoc(),
                            qualified, within_type);
  }

  // A value whose type is not known yet.
  static bool depends(QualType type) { return type->isDependentType() && !type->isReferenceType(); }

  bool decide(Expr const *condition) {
    if (!condition) return true;
    if (auto const *full = dyn_cast<FullExpr>(condition)) condition = full->getSubExpr();
    while (auto const *parens = dyn_cast<ParenExpr>(condition)) condition = parens->getSubExpr();
    decisions_.insert(condition);
    return true;
  }

  void state(VarDecl const *variable, Expr const *reference) {
    if (!passive_ && !no_state_) collect_.state(variable, reference, in_template_);
  }

  ASTContext const &context_;
  ScalarState const &scalars_;
  PragmaIndex const &index_;
  bool const children_first_;
  Facts &facts_;
  Collector collect_;
  llvm::SmallPtrSet<Expr const *, 32> decisions_;
};

} // namespace

void collect_tree(ASTContext &context, SourceMap const &map, PragmaIndex const &index, Request const &request,
                  Facts &facts) {
  Reals reals(map);
  collect_externals(context, map, index, facts, reals);
  collect_symbolic_ints(context, map, facts, reals);
  ScalarState const scalars(context, map);
  Surroundings const surroundings(context, map, reals, scalars, facts);
  Visitor visitor(context, map, reals, scalars, surroundings, index, request.children_first, facts);
  visitor.TraverseDecl(context.getTranslationUnitDecl());
  visitor.finish();
  collect_instances(context, map, reals, scalars, surroundings, facts);
  collect_operand_order(context, map, reals, facts);
  collect_layouts(context, map, reals, facts);
  attach_function_pragmas(visitor.definitions, map, reals, scalars, index, facts);
  attach_configured_kernels(request, visitor.definitions, map, reals, scalars, facts);
  note_statics(context, map, scalars, facts);
  collect_c_declarations(context, map, facts);
  collect_c_jumps(context, map, facts);
  collect_c_generic(context, map, facts);
  collect_c_specifiers(context, map, facts);
  collect_c_arrays(context, map, facts);
  collect_c_literals(context, map, facts);
  collect_c_names(context, map, facts);
  collect_anonymous_structs(context, map, reals, facts);
  collect_decisions(context, map, reals, index, facts);
  collect_boundaries(context, visitor.definitions, map, reals, facts);
  collect_links(context, visitor.definitions, map, facts);
}

} // namespace symreal::rewrite
