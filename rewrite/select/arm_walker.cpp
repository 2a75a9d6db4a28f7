#include "rewrite/select/arm_walker.h"

#include "rewrite/source/walk.h"

namespace symreal::rewrite {
using namespace clang;

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
  bool const never_ends = !condition || (condition->EvaluateAsBooleanCondition(always, analysis_.context()) && always);
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

Arms ArmAnalysis::arms(std::vector<Stmt const *> const &statements, Allowed const &allowed) {
  ArmWalker walker(*this, ArmWalker::Scope::arm, allowed);
  for (Stmt const *statement : statements) walker.statement(statement, true);
  return std::move(walker.result);
}

namespace {

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

std::optional<Blocker> ArmAnalysis::body(FunctionDecl const *function, Part part) {
  static Allowed const nothing;
  ArmWalker walker(*this, ArmWalker::Scope::body, nothing, function);
  for (ParmVarDecl const *parameter : function->parameters()) walker.own(parameter);
  if (auto const *constructor = dyn_cast<CXXConstructorDecl>(function))
    for (CXXCtorInitializer const *initializer : constructor->inits()) walker.expression(initializer->getInit());
  auto const *block = dyn_cast<CompoundStmt>(function->getBody());
  if (part == Part::whole || !block) {
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
