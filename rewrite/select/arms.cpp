#include "rewrite/select/arms.h"

#include "rewrite/model/library.h"
#include "rewrite/source/walk.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

bool in_eigen(Decl const *declaration) {
  for (DeclContext const *scope = declaration->getDeclContext(); scope; scope = scope->getParent())
    if (auto const *space = dyn_cast<NamespaceDecl>(scope); space && space->getName() == "Eigen") return true;
  return false;
}

// Fixed arrays of numbers of known libraries: their operators compute only.
bool is_number_array(CXXRecordDecl const *record) {
  if (in_eigen(record)) return true;
  return record->isInStdNamespace() && (record->getName() == "array" || record->getName() == "complex");
}

// Whether a `return` stands under a condition of REALs.
class RealReturns : public Walk {
public:
  explicit RealReturns(Conditions const &conditions) : conditions_(conditions) {}
  bool TraverseLambdaExpr(LambdaExpr *) override { return true; }
  bool TraverseIfStmt(IfStmt *choice) override {
    bool const on_real = !choice->isConsteval() && conditions_.classify(choice->getCond()).is_real;
    within_ += on_real;
    Walk::TraverseIfStmt(choice);
    within_ -= on_real;
    return true;
  }
  bool VisitReturnStmt(ReturnStmt *) override {
    found = found || within_ > 0;
    return true;
  }
  bool found = false;

private:
  Conditions const &conditions_;
  int within_ = 0;
};

class Locals : public Walk {
public:
  explicit Locals(ArmWalker &walker) : walker_(walker) {}
  bool TraverseLambdaExpr(LambdaExpr *) override { return true; }
  bool VisitVarDecl(VarDecl *variable) override {
    if (variable->hasLocalStorage()) walker_.own(variable);
    return true;
  }

private:
  ArmWalker &walker_;
};

} // namespace

void ArmWalker::block(SourceLocation location, Reason reason) {
  if (!blocked()) result.blocker = {location, std::move(reason)};
}

void ArmWalker::statement(Stmt const *statement, bool is_last) {
  if (!statement || blocked()) return;
  if (auto const *value = dyn_cast<Expr>(statement)) return expression(value);
  switch (statement->getStmtClass()) {
  case Stmt::NullStmtClass: return;
  case Stmt::CompoundStmtClass: {
    auto const *block = cast<CompoundStmt>(statement);
    for (Stmt const *inner : block->body()) this->statement(inner, is_last && inner == block->body_back());
    return;
  }
  case Stmt::AttributedStmtClass: return this->statement(cast<AttributedStmt>(statement)->getSubStmt(), is_last);
  case Stmt::DeclStmtClass: return declaration(cast<DeclStmt>(statement));
  case Stmt::IfStmtClass: return choice(cast<IfStmt>(statement), is_last);
  case Stmt::ForStmtClass: {
    auto const *each = cast<ForStmt>(statement);
    this->statement(each->getInit(), false);
    if (each->getConditionVariable()) variable(each->getConditionVariable());
    loop(each, each->getCond(), each->getBody());
    return this->statement(each->getInc(), false);
  }
  case Stmt::WhileStmtClass: {
    auto const *each = cast<WhileStmt>(statement);
    if (each->getConditionVariable()) variable(each->getConditionVariable());
    return loop(each, each->getCond(), each->getBody());
  }
  case Stmt::DoStmtClass:
    return loop(statement, cast<DoStmt>(statement)->getCond(), cast<DoStmt>(statement)->getBody());
  case Stmt::CXXForRangeStmtClass: {
    auto const *each = cast<CXXForRangeStmt>(statement);
    expression(each->getRangeInit());
    own(each->getLoopVariable());
    ++loops_;
    this->statement(each->getBody(), false);
    --loops_;
    return;
  }
  case Stmt::SwitchStmtClass: {
    auto const *choice = cast<SwitchStmt>(statement);
    if (choice->getInit() || choice->getConditionVariable())
      return block(choice->getBeginLoc(), {ReasonId::declaration_in_switch});
    expression(choice->getCond());
    ++loops_; // a `break` ends it
    this->statement(choice->getBody(), false);
    --loops_;
    return;
  }
  case Stmt::CaseStmtClass:
  case Stmt::DefaultStmtClass: return this->statement(cast<SwitchCase>(statement)->getSubStmt(), is_last);
  case Stmt::ReturnStmtClass: {
    auto const *value = cast<ReturnStmt>(statement)->getRetValue();
    if (scope_ == Scope::arm && !allowed_.returns) return block(statement->getBeginLoc(), {ReasonId::returns});
    if (scope_ == Scope::arm && !is_last) return block(statement->getBeginLoc(), {ReasonId::early_return});
    result.returns = true;
    if (value) expression(value);
    return;
  }
  case Stmt::BreakStmtClass: return jump(statement, {ReasonId::breaks});
  case Stmt::ContinueStmtClass: return jump(statement, {ReasonId::continues});
  case Stmt::GotoStmtClass:
  case Stmt::IndirectGotoStmtClass: return block(statement->getBeginLoc(), {ReasonId::jumps});
  case Stmt::LabelStmtClass: return block(statement->getBeginLoc(), {ReasonId::label});
  case Stmt::GCCAsmStmtClass:
  case Stmt::MSAsmStmtClass: return block(statement->getBeginLoc(), {ReasonId::assembly});
  case Stmt::CXXTryStmtClass: return block(statement->getBeginLoc(), {ReasonId::tries});
  default: return block(statement->getBeginLoc(), {ReasonId::statement_kind, statement->getStmtClassName()});
  }
}

void ArmWalker::jump(Stmt const *jump, Reason reason) {
  if (loops_ == 0) block(jump->getBeginLoc(), std::move(reason));
}

void ArmWalker::declaration(DeclStmt const *statement) {
  for (Decl const *declared : statement->decls())
    if (auto const *one = dyn_cast<VarDecl>(declared)) variable(one);
}

void ArmWalker::variable(VarDecl const *variable) {
  if (variable->getType().isVolatileQualified()) return block(variable->getLocation(), {ReasonId::volatile_variable});
  if (variable->isStaticLocal()) {
    if (!variable->isConstexpr() && !analysis_.reals_.is_passive(variable) && !variable->getType().isConstQualified())
      block(variable->getLocation(), {ReasonId::static_variable});
    return;
  }
  if (variable->hasLocalStorage()) own(variable);
  if (variable->needsDestruction(variable->getASTContext()) != QualType::DK_none)
    return block(variable->getLocation(), {ReasonId::destructor});
  if (variable->getInit()) expression(variable->getInit());
}

void ArmWalker::loop(Stmt const *loop, Expr const *condition, Stmt const *body) {
  bool const bounded = analysis_.bounded_loops.count(loop) != 0;
  if (condition && !bounded && analysis_.conditions_.mentions_comparison(condition))
    return block(loop->getBeginLoc(), {ReasonId::loop_on_real});
  bool always = false;
  bool const never_ends = !condition || (condition->EvaluateAsBooleanCondition(always, analysis_.context_) && always);
  if (scope_ == Scope::body && never_ends && !bounded) block(loop->getBeginLoc(), {ReasonId::endless_loop});
  if (condition) expression(condition);
  ++loops_;
  statement(body, false);
  --loops_;
}

void ArmWalker::choice(IfStmt const *choice, bool is_last) {
  if (allowed_.breaks.count(choice) != 0) return expression(choice->getCond());
  if (choice->getInit()) statement(choice->getInit(), false);
  if (choice->getConditionVariable()) variable(choice->getConditionVariable());
  if (!choice->isConsteval()) expression(choice->getCond());
  // Both arms of a decision on REALs are executed: a jump in one would take the other with it.
  bool const on_real = !choice->isConsteval() && analysis_.conditions_.classify(choice->getCond()).is_real;
  int const loops = loops_;
  if (on_real) loops_ = 0;
  // A `return` in an arm is noted; the statements after it are executed without effect.
  statement(choice->getThen(), is_last || on_real);
  statement(choice->getElse(), is_last || on_real);
  loops_ = loops;
}

void ArmWalker::expression(Expr const *expression) {
  if (!expression || blocked()) return;
  if (expression->getType().isVolatileQualified()) return block(expression->getExprLoc(), {ReasonId::volatile_object});
  switch (expression->getStmtClass()) {
  case Stmt::CallExprClass:
  case Stmt::CXXMemberCallExprClass:
  case Stmt::CXXOperatorCallExprClass:
  case Stmt::UserDefinedLiteralClass: return call(cast<CallExpr>(expression));
  case Stmt::CXXConstructExprClass:
  case Stmt::CXXTemporaryObjectExprClass: return construction(cast<CXXConstructExpr>(expression));
  case Stmt::BinaryOperatorClass:
  case Stmt::CompoundAssignOperatorClass: return binary(cast<BinaryOperator>(expression));
  case Stmt::UnaryOperatorClass: {
    auto const *unary = cast<UnaryOperator>(expression);
    if (unary->isIncrementDecrementOp()) return assignment(unary->getSubExpr());
    return this->expression(unary->getSubExpr());
  }
  case Stmt::CXXDefaultArgExprClass: return this->expression(cast<CXXDefaultArgExpr>(expression)->getExpr());
  case Stmt::CXXDefaultInitExprClass: return this->expression(cast<CXXDefaultInitExpr>(expression)->getExpr());
  case Stmt::CXXThrowExprClass: return block(expression->getExprLoc(), {ReasonId::throws});
  case Stmt::CXXNewExprClass: return block(expression->getExprLoc(), {ReasonId::makes_new});
  case Stmt::CXXDeleteExprClass: return block(expression->getExprLoc(), {ReasonId::deletes});
  case Stmt::LambdaExprClass: return block(expression->getExprLoc(), {ReasonId::lambda});
  case Stmt::StmtExprClass: return block(expression->getExprLoc(), {ReasonId::statement_expression});
  case Stmt::VAArgExprClass: return block(expression->getExprLoc(), {ReasonId::variable_arguments});
  case Stmt::UnaryExprOrTypeTraitExprClass:
  case Stmt::CXXNoexceptExprClass: return; // not evaluated
  case Stmt::CXXBindTemporaryExprClass: return block(expression->getExprLoc(), {ReasonId::destructor});
  // Expressions that only compute from their operands.
  case Stmt::ParenExprClass:
  case Stmt::ImplicitCastExprClass:
  case Stmt::CStyleCastExprClass:
  case Stmt::CXXStaticCastExprClass:
  case Stmt::CXXConstCastExprClass:
  case Stmt::CXXFunctionalCastExprClass:
  case Stmt::ConditionalOperatorClass:
  case Stmt::BinaryConditionalOperatorClass:
  case Stmt::OpaqueValueExprClass:
  case Stmt::MemberExprClass:
  case Stmt::ArraySubscriptExprClass:
  case Stmt::InitListExprClass:
  case Stmt::ConstantExprClass:
  case Stmt::ExprWithCleanupsClass:
  case Stmt::MaterializeTemporaryExprClass:
  case Stmt::CXXStdInitializerListExprClass:
  case Stmt::CXXRewrittenBinaryOperatorClass:
  case Stmt::SubstNonTypeTemplateParmExprClass:
  case Stmt::CompoundLiteralExprClass:
  case Stmt::DeclRefExprClass:
  case Stmt::CXXThisExprClass:
  case Stmt::FloatingLiteralClass:
  case Stmt::IntegerLiteralClass:
  case Stmt::CharacterLiteralClass:
  case Stmt::StringLiteralClass:
  case Stmt::PredefinedExprClass:
  case Stmt::CXXBoolLiteralExprClass:
  case Stmt::CXXNullPtrLiteralExprClass:
  case Stmt::GNUNullExprClass:
  case Stmt::ImplicitValueInitExprClass:
  case Stmt::CXXScalarValueInitExprClass:
  case Stmt::TypeTraitExprClass:
    for (Stmt const *part : expression->children())
      if (auto const *inner = dyn_cast_or_null<Expr>(part)) this->expression(inner);
    return;
  default: return block(expression->getExprLoc(), {ReasonId::expression_kind, expression->getStmtClassName()});
  }
}

void ArmWalker::binary(BinaryOperator const *binary) {
  expression(binary->getRHS());
  if (binary->isAssignmentOp())
    assignment(binary->getLHS());
  else
    expression(binary->getLHS());
}

// modf(x, &whole) and its like write through their pointers.
void ArmWalker::math_call(CallExpr const *call) {
  for (Expr const *argument : call->arguments()) {
    Expr const *written = argument->IgnoreParenImpCasts();
    auto const *address = dyn_cast<UnaryOperator>(written);
    if (!written->getType()->isPointerType())
      expression(argument);
    else if (address && address->getOpcode() == UO_AddrOf)
      assignment(address->getSubExpr());
    else
      block(argument->getExprLoc(), {ReasonId::written_through_pointer});
  }
}

bool ArmWalker::library_call(CallExpr const *call, FunctionDecl const *function) {
  if (is_std_function(function, {"min", "max", "abs", "clamp", "move", "forward", "get", "size", "begin", "end", "real",
                                 "imag", "norm", "conj", "data"})) {
    for (Expr const *argument : call->arguments()) expression(argument);
    return true;
  }
  auto const *method = dyn_cast<CXXMethodDecl>(function);
  bool const numbers = method ? is_number_array(method->getParent()) : in_eigen(function);
  if (!numbers && !(method && method->getParent()->isInStdNamespace())) return false;
  OverloadedOperatorKind const op = function->getOverloadedOperator();
  bool const assigns = numbers && (op == OO_Equal || op == OO_PlusEqual || op == OO_MinusEqual || op == OO_StarEqual ||
                                   op == OO_SlashEqual);
  bool const looks = op == OO_Subscript || (op == OO_Call && numbers) ||
                     (function->getDeclName().isIdentifier() && library::has(function->getName(), library::VIEWS)) ||
                     (numbers && (!method || method->isConst() || method->isStatic()));
  if (!assigns && !looks) return false;
  if (auto const *member = dyn_cast<CXXMemberCallExpr>(call)) expression(member->getImplicitObjectArgument());
  for (unsigned i = 0; i < call->getNumArgs(); ++i)
    if (i > 0 || !assigns) expression(call->getArg(i));
  if (assigns) assignment(call->getArg(0));
  return true;
}

void ArmWalker::call(CallExpr const *call) {
  FunctionDecl const *function = call->getDirectCallee();
  if (!function) return block(call->getExprLoc(), {ReasonId::call_by_pointer});
  if (analysis_.reals_.is_math(function)) return math_call(call);
  if (library_call(call, function)) return;
  // The assignment that the compiler wrote: member by member.
  auto const *method = dyn_cast<CXXMethodDecl>(function);
  if (method && method->isTrivial() && (method->isCopyAssignmentOperator() || method->isMoveAssignmentOperator())) {
    expression(call->getArg(1));
    return assignment(call->getArg(0));
  }
  if (auto const *member = dyn_cast<CXXMemberCallExpr>(call)) expression(member->getImplicitObjectArgument());
  for (Expr const *argument : call->arguments()) expression(argument);
  if (blocked()) return;
  if (std::optional<Reason> const why = analysis_.call_of(function)) block(call->getExprLoc(), *why);
}

void ArmWalker::construction(CXXConstructExpr const *construction) {
  for (Expr const *argument : construction->arguments()) expression(argument);
  CXXConstructorDecl const *constructor = construction->getConstructor();
  if (blocked() || constructor->isTrivial() || constructor->isDefaulted() || is_number_array(constructor->getParent()))
    return;
  if (std::optional<Reason> const why = analysis_.call_of(constructor)) block(construction->getExprLoc(), *why);
}

Arms ArmAnalysis::arms(std::vector<Stmt const *> const &statements, Allowed const &allowed) {
  ArmWalker walker(*this, ArmWalker::Scope::arm, allowed);
  for (Stmt const *statement : statements) walker.statement(statement, true);
  return std::move(walker.result);
}

std::optional<Blocker> ArmAnalysis::body(FunctionDecl const *function, BodyPart part) {
  static Allowed const nothing;
  ArmWalker walker(*this, ArmWalker::Scope::body, nothing, function);
  for (ParmVarDecl const *parameter : function->parameters()) walker.own(parameter);
  if (auto const *constructor = dyn_cast<CXXConstructorDecl>(function))
    for (CXXCtorInitializer const *initializer : constructor->inits()) walker.expression(initializer->getInit());
  auto const *block = dyn_cast<CompoundStmt>(function->getBody());
  if (part == BodyPart::whole || !block) {
    walker.statement(function->getBody(), true);
    return std::move(walker.result.blocker);
  }
  bool after = false;
  for (Stmt *statement : block->body()) {
    RealReturns returns(conditions_);
    if (!after) returns.TraverseStmt(statement);
    after = after || returns.found;
    if (after)
      walker.statement(statement, true);
    else
      Locals(walker).TraverseStmt(statement);
  }
  return std::move(walker.result.blocker);
}

std::optional<Reason> ArmAnalysis::call_of(FunctionDecl const *function) {
  std::string const name = "'" + function->getNameAsString() + "'";
  FunctionDecl const *definition = nullptr;
  if (auto const *method = dyn_cast<CXXMethodDecl>(function);
      method && method->isVirtual() && !method->hasAttr<FinalAttr>())
    return Reason{ReasonId::virtual_call, name};
  if (function->isDefaulted() && function->isTrivial()) return std::nullopt;
  if (!function->hasBody(definition)) return Reason{ReasonId::unseen_call, name};
  Reason const itself{ReasonId::recursive_call, name};
  auto const [at, is_new] = known_.try_emplace(definition, itself);
  if (!is_new) return at->second;
  std::optional<Reason> why;
  if (std::optional<Blocker> const blocker = body(definition))
    why = blocker->reason == itself
              ? itself
              : Reason{ReasonId::call_with, name, {blocker->reason}, map_.place(blocker->location)};
  known_[definition] = why;
  return why;
}

} // namespace symreal::rewrite
