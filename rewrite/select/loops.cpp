#include "rewrite/select/decisions.h"

#include "rewrite/source/walk.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

struct LoopParts {
  Stmt const *init = nullptr;
  Expr const *condition = nullptr;
  Stmt const *increment = nullptr;
  Stmt const *body = nullptr;
};

std::optional<LoopParts> parts(Stmt const *loop) {
  if (auto const *one = dyn_cast<ForStmt>(loop)) {
    if (one->getConditionVariable()) return std::nullopt;
    return LoopParts{one->getInit(), one->getCond(), one->getInc(), one->getBody()};
  }
  if (auto const *one = dyn_cast<WhileStmt>(loop)) {
    if (one->getConditionVariable()) return std::nullopt;
    return LoopParts{nullptr, one->getCond(), nullptr, one->getBody()};
  }
  if (auto const *one = dyn_cast<DoStmt>(loop)) return LoopParts{nullptr, one->getCond(), nullptr, one->getBody()};
  return std::nullopt;
}

// `if (...) break;` among the statements of a loop's body.
bool is_break(IfStmt const *choice) {
  if (choice->getElse() || choice->getInit() || choice->getConditionVariable() || choice->isConstexpr()) return false;
  Stmt const *then = choice->getThen();
  if (auto const *block = dyn_cast<CompoundStmt>(then)) then = block->size() == 1 ? block->body_front() : nullptr;
  return then && isa<BreakStmt>(then);
}

class UseBehindLoop : public Walk {
public:
  UseBehindLoop(VarDecl const *variable, SourceManager const &sources, SourceLocation end)
      : variable_(variable),
        sources_(sources),
        end_(end) {}
  bool VisitDeclRefExpr(DeclRefExpr *reference) override {
    found = found || (reference->getDecl() == variable_ &&
                      sources_.isBeforeInTranslationUnit(end_, sources_.getExpansionLoc(reference->getLocation())));
    return !found;
  }
  bool found = false;

private:
  VarDecl const *variable_;
  SourceManager const &sources_;
  SourceLocation end_;
};

class Assigned : public Walk {
public:
  bool VisitUnaryOperator(UnaryOperator *unary) override {
    if (unary->isIncrementDecrementOp()) note(unary->getSubExpr());
    return true;
  }
  bool VisitBinaryOperator(BinaryOperator *binary) override {
    if (binary->isAssignmentOp()) note(binary->getLHS());
    return true;
  }
  std::set<VarDecl const *> integers;

private:
  void note(Expr const *target) {
    auto const *reference = dyn_cast<DeclRefExpr>(target->IgnoreParens());
    auto const *variable = reference ? dyn_cast<VarDecl>(reference->getDecl()) : nullptr;
    if (variable && variable->hasLocalStorage() && variable->getType()->isIntegerType()) integers.insert(variable);
  }
};

} // namespace

void DecisionCollector::report(DiagnosticId id, Place const &place, std::string message) {
  for (Diagnostic const &known : facts_.diagnostics)
    if (known.id == id && to_string(known.place) == to_string(place)) return;
  facts_.diagnostics.push_back({id, place, std::move(message)});
}

void DecisionCollector::free_loop(Stmt const *loop, Expr const *condition) {
  if (!condition || analysis_.bounded_loops.count(loop) != 0 || !conditions_.classify(condition).is_real) return;
  if (std::optional<Site> const at = site(loop->getBeginLoc(), condition))
    refuse(*at, {loop->getBeginLoc(), {ReasonId::unbounded_loop}});
}

void DecisionCollector::attach_pragmas(Stmt const *statement) {
  if (index_.statement_pragmas.empty()) return;
  std::map<Span, std::pair<SourceLocation, CompoundStmt const *>> innermost;
  std::vector<Stmt const *> pending = {statement};
  while (!pending.empty()) { // a block comes before those within it
    Stmt const *next = pending.back();
    pending.pop_back();
    if (!next) continue;
    if (auto const *block = dyn_cast<CompoundStmt>(next))
      for (auto const &[span, place] : index_.statement_pragmas)
        if (map_.sources().isBeforeInTranslationUnit(block->getLBracLoc(), place) &&
            map_.sources().isBeforeInTranslationUnit(place, block->getRBracLoc()))
          innermost[span] = {place, block};
    for (Stmt const *child : next->children()) pending.push_back(child);
  }
  for (auto const &[span, found] : innermost) attach_pragma(span, found.first, found.second);
}

void DecisionCollector::attach_pragma(Span const &span, SourceLocation place, CompoundStmt const *block) {
  attached_.insert(span);
  PragmaFact &pragma = facts_.pragmas[span];
  SourceManager const &sources = map_.sources();
  Stmt const *next = nullptr;
  for (Stmt const *child : block->body()) {
    SourceLocation const begin = sources.getExpansionLoc(child->getBeginLoc());
    SourceLocation const end = sources.getExpansionLoc(child->getEndLoc());
    if (sources.isBeforeInTranslationUnit(place, begin)) {
      next = child;
      break;
    }
    if (sources.isBeforeInTranslationUnit(place, end))
      return report(DiagnosticId::pragma_position, pragma.place, "this pragma stands within a statement");
  }
  if (!next) return report(DiagnosticId::pragma_position, pragma.place, "no statement follows this pragma");
  if (isa<DeclStmt>(next))
    return report(DiagnosticId::pragma_position, pragma.place,
                  "this pragma stands before a declaration; it belongs before a statement or, for a whole function, "
                  "before that");
  if (pragma.clause(Clause::loop)) bound_loop(pragma, next, block);
}

std::set<VarDecl const *> DecisionCollector::counters(Stmt const *loop, CompoundStmt const *block) const {
  Assigned assigned;
  assigned.TraverseStmt(const_cast<Stmt *>(loop));
  std::set<VarDecl const *> result;
  for (Stmt const *statement : block->body())
    if (auto const *declaration = dyn_cast<DeclStmt>(statement))
      for (Decl const *declared : declaration->decls()) {
        auto const *variable = dyn_cast<VarDecl>(declared);
        if (!variable || assigned.integers.count(variable) == 0) continue;
        UseBehindLoop uses(variable, map_.sources(), map_.sources().getExpansionLoc(loop->getEndLoc()));
        uses.TraverseStmt(const_cast<CompoundStmt *>(block));
        if (!uses.found) result.insert(variable);
      }
  return result;
}

void DecisionCollector::bound_loop(PragmaFact &pragma, Stmt const *loop, CompoundStmt const *block) {
  auto const wrong = [&](std::string message, SourceLocation place = {}) {
    report(DiagnosticId::pragma_loop, pragma.place, std::move(message));
    if (place.isValid()) facts_.diagnostics.back().notes = {{map_.place(place), "this blocks it"}};
  };
  std::optional<LoopParts> const loop_parts = parts(loop);
  if (!loop_parts) return wrong("no loop follows this pragma");
  analysis_.bounded_loops.insert(loop);
  if (function_->isDependentContext()) return; // its instantiations are collected
  LoopParts const &part = *loop_parts;
  if (auto const *declaration = dyn_cast_or_null<DeclStmt>(part.init))
    for (Decl const *declared : declaration->decls())
      if (auto const *variable = dyn_cast<VarDecl>(declared); variable && reals_.carries_real(variable->getType()))
        return wrong("'" + variable->getNameAsString() + "' must be declared before the loop", variable->getLocation());
  Site const at{*map_.token(loop->getBeginLoc()), map_.frame(loop->getBeginLoc()), loop->getSourceRange()};
  if (!map_.sources().getSLocEntry(at.frame).isFile()) return wrong("the loop is made by a macro");
  Condition const condition = conditions_.classify(part.condition);
  if (condition.blocker)
    return wrong("the loop's condition has " + words(condition.blocker->reason), condition.blocker->location);

  bool has_exit = condition.is_real;
  std::vector<Alteration> alterations = condition.joints;
  Allowed allowed{.frame = at.frame, .in_loop = true};
  std::vector<Stmt const *> statements = {part.body};
  if (auto const *body = dyn_cast<CompoundStmt>(part.body)) statements.assign(body->body_begin(), body->body_end());
  for (Stmt const *statement : statements) {
    auto const *choice = dyn_cast<IfStmt>(statement);
    if (!choice || !is_break(choice)) continue;
    Condition const exit = conditions_.classify(choice->getCond());
    if (!exit.is_real) continue;
    if (exit.blocker) return wrong("the exit's condition has " + words(exit.blocker->reason), exit.blocker->location);
    std::optional<Alteration> const opening =
        replacing(at.frame, {choice->getIfLoc(), choice->getLParenLoc()}, "SYMREAL_REAL_BREAK(");
    if (!opening) return wrong("an exit of the loop is spelled by a macro in part", choice->getIfLoc());
    alterations.insert(alterations.end(), exit.joints.begin(), exit.joints.end());
    alterations.push_back(*opening);
    allowed.breaks.insert(choice);
    breaks_.insert(choice);
    has_exit = true;
  }
  if (!has_exit) return wrong("no exit of this loop depends on a REAL");

  allowed.counters = counters(loop, block);
  std::vector<Stmt const *> all = {part.init, part.condition, part.increment};
  all.insert(all.end(), statements.begin(), statements.end());
  Arms const arms = analysis_.arms(all, allowed);
  if (arms.blocker) return wrong("the loop has " + words(arms.blocker->reason), arms.blocker->location);
  std::optional<Span> const span =
      part.condition ? map_.range_in(at.frame, part.condition->getSourceRange()) : empty_condition(cast<ForStmt>(loop));
  if (!span) return wrong("the loop's condition is spelled by a macro in part");
  if (part.condition)
    alterations.push_back({*span, "SYMREAL_REAL_TEST(", ")"});
  else
    alterations.push_back({*span, "SYMREAL_REAL_TEST()", ""});
  std::string targets;
  for (std::string const &target : arms.targets) targets += "(" + target + ")";
  if (pragma.loop_targets && *pragma.loop_targets != targets)
    return wrong("the loop assigns other variables in another instantiation or source");
  pragma.loop_targets = targets;
  pragma.tests_late = isa<DoStmt>(loop);
  accept(at, std::move(alterations));
}

// The `;` behind the place where the condition of `for (;;)` would stand.
std::optional<Span> DecisionCollector::empty_condition(ForStmt const *loop) const {
  SourceManager const &sources = map_.sources();
  SourceLocation const start = loop->getInit() ? loop->getInit()->getEndLoc() : loop->getLParenLoc();
  // A declaration ends with its `;`, an expression before it.
  int wanted = loop->getInit() && isa<DeclStmt>(loop->getInit()) ? 1 : 2;
  SourceLocation at = start;
  while (wanted > 0) {
    std::optional<Token> const token = Lexer::findNextToken(at, sources, map_.language());
    if (!token || token->is(tok::r_paren) || token->is(tok::eof)) return std::nullopt;
    at = token->getLocation();
    if (token->is(tok::semi)) --wanted;
  }
  return map_.token(at);
}

void DecisionCollector::check_pragmas() {
  for (auto const &[span, place] : index_.statement_pragmas)
    if (attached_.count(span) == 0)
      report(DiagnosticId::pragma_position, facts_.pragmas[span].place,
             "this pragma stands where no statement can stand");
}

} // namespace symreal::rewrite
