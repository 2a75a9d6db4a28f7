#include "rewrite/select/decision_collector.h"

namespace symreal::rewrite {
using namespace clang;

void DecisionCollector::function(FunctionDecl const *function) {
  function_ = function;
  returns_.reset();
  breaks_.clear();
  attach_pragmas(function->getBody());
  if (function->isDependentContext()) return; // its instantiations are collected
  if (auto const *constructor = dyn_cast<CXXConstructorDecl>(function))
    for (CXXCtorInitializer const *initializer : constructor->inits())
      if (initializer->isWritten()) walk(initializer->getInit());
  walk(function->getBody());
}

void DecisionCollector::walk(Stmt const *statement) {
  if (!statement) return;
  switch (statement->getStmtClass()) {
  case Stmt::ConstantExprClass:
  case Stmt::UnaryExprOrTypeTraitExprClass:
  case Stmt::CXXNoexceptExprClass:
  case Stmt::CXXTypeidExprClass: return;
  default: break;
  }
  visit(statement);
  bool const is_lambda = isa<LambdaExpr>(statement);
  lambdas_ += is_lambda;
  parents_.push_back(statement);
  if (auto const *declaration = dyn_cast<DeclStmt>(statement)) {
    for (Decl const *declared : declaration->decls())
      if (auto const *variable = dyn_cast<VarDecl>(declared); variable && !variable->isConstexpr())
        walk(variable->getInit());
  } else if (auto const *defaulted = dyn_cast<CXXDefaultArgExpr>(statement)) {
    (void)defaulted; // written elsewhere
  } else
    for (Stmt const *child : statement->children()) walk(child);
  parents_.pop_back();
  lambdas_ -= is_lambda;
}

void DecisionCollector::visit(Stmt const *statement) {
  note_deciding(statement);
  if (auto const *choice = dyn_cast<IfStmt>(statement)) choose_statement(choice);
  if (auto const *choice = dyn_cast<ConditionalOperator>(statement)) choose_value(choice);
  if (auto const *loop = dyn_cast<ForStmt>(statement)) free_loop(loop, loop->getCond());
  if (auto const *loop = dyn_cast<WhileStmt>(statement)) free_loop(loop, loop->getCond());
  if (auto const *loop = dyn_cast<DoStmt>(statement)) free_loop(loop, loop->getCond());
}

std::optional<DecisionCollector::Site> DecisionCollector::site(SourceLocation token, Expr const *condition) {
  std::optional<Span> const key = map_.token(token);
  if (!key) return std::nullopt; // pasted together, or outside the roots: it cannot be changed or explained
  return Site{*key, map_.frame(token), condition->getSourceRange()};
}

void DecisionCollector::refuse(Site const &site, Blocker const &blocker) {
  note(site, blocker, facts_.decisions[site.key].refusals);
}

void DecisionCollector::note(Site const &site, Blocker const &blocker, std::vector<Refusal> &refusals) const {
  Refusal refusal{map_.place(site.condition.getBegin()), map_.place(site.condition.getEnd()).line, blocker.reason,
                  map_.place(blocker.location)};
  for (Refusal const &known : refusals)
    if (to_string(known.condition) == to_string(refusal.condition)) return;
  refusals.push_back(std::move(refusal));
}

void DecisionCollector::accept(Site const &site, std::vector<Alteration> alterations, std::optional<Span> needs) {
  DecisionFact &fact = facts_.decisions[site.key];
  if (!fact.alterations.empty() && fact.alterations != alterations)
    return refuse(site, {site.condition.getBegin(), {ReasonId::differs_here}});
  note(site, {site.condition.getBegin(), {ReasonId::unsaid}}, fact.uses);
  fact.alterations = std::move(alterations);
  fact.needs = std::move(needs);
}

namespace {

// A macro's argument must not hold a directive.
bool has_directive(std::string const &text) {
  for (std::size_t line = text.find('\n'); line != std::string::npos; line = text.find('\n', line + 1)) {
    std::size_t const first = text.find_first_not_of(" \t", line + 1);
    if (first != std::string::npos && text[first] == '#') return true;
  }
  return false;
}

} // namespace

std::optional<Span> DecisionCollector::condition_span(Site const &site, Condition const &condition) {
  SourceLocation const begin = site.condition.getBegin();
  if (function_->isConstexpr() && lambdas_ == 0) {
    refuse(site, {function_->getLocation(), {ReasonId::constexpr_function}});
    return std::nullopt;
  }
  if (condition.blocker) {
    refuse(site, *condition.blocker);
    return std::nullopt;
  }
  std::optional<Span> span = map_.range_in(site.frame, site.condition);
  if (!span) {
    refuse(site, {begin, {ReasonId::condition_spelled_by_macro}});
    return std::nullopt;
  }
  if (has_directive(map_.text_in(site.frame, *span))) {
    refuse(site, {begin, {ReasonId::directive_in_condition}});
    return std::nullopt;
  }
  for (Alteration const &joint : condition.joints)
    if (joint.span.file != span->file || joint.span.begin < span->begin || joint.span.end > span->end) {
      refuse(site, {begin, {ReasonId::condition_joined_by_macro}});
      return std::nullopt;
    }
  return span;
}

std::optional<Alteration> DecisionCollector::replacing(FileID frame, SourceRange range, std::string text) const {
  std::optional<Span> const span = map_.range_in(frame, range);
  if (!span) return std::nullopt;
  std::string const before = map_.text_in(frame, *span);
  if (before.find("\\\n") != std::string::npos || has_directive(before)) return std::nullopt;
  for (char c : before)
    if (c == '\n') text += '\n';
  return Alteration{*span, std::move(text), "", true};
}

void DecisionCollector::choose_statement(IfStmt const *choice) {
  if (choice->isConsteval() || choice->isConstexpr() || breaks_.count(choice) != 0) return;
  Condition const condition = conditions_.classify(choice->getCond());
  if (!condition.is_real) return;
  std::optional<Site> const at = site(choice->getIfLoc(), choice->getCond());
  if (!at) return;
  if (choice->getInit() || choice->getConditionVariable())
    return refuse(*at, {choice->getIfLoc(), {ReasonId::declaration_in_condition}});
  std::optional<Span> const span = condition_span(*at, condition);
  if (!span) return;
  Allowed allowed{.frame = at->frame};
  allowed.returns =
      lambdas_ == 0 && Reals::is_double(function_->getReturnType()) && !function_->getReturnType()->isReferenceType();
  Arms const arms = analysis_.arms({choice->getThen(), choice->getElse()}, allowed);
  if (arms.blocker) return refuse(*at, *arms.blocker);
  std::optional<Span> needs;
  if (arms.returns) {
    Returns const &returns = early_returns();
    if (returns.blocker) return refuse(*at, *returns.blocker);
    needs = returns.brace;
  }
  std::string head = arms.returns ? "SYMREAL_REAL_RETURN_IF(" : "SYMREAL_REAL_IF(";
  for (std::string const &target : arms.targets) head += "(" + target + ")";
  std::optional<Alteration> const opening =
      replacing(at->frame, {choice->getIfLoc(), choice->getLParenLoc()}, head + ", ");
  if (!opening) return refuse(*at, {choice->getIfLoc(), {ReasonId::if_in_parts}});
  std::vector<Alteration> alterations = condition.joints;
  alterations.push_back(*opening);
  accept(*at, std::move(alterations), needs);
}

// An integer that at once becomes a REAL can be one from the start.
bool DecisionCollector::becomes_number(ConditionalOperator const *choice) const {
  if (Reals::is_double(choice->getType())) return true;
  if (!choice->getType()->isIntegerType()) return false;
  auto parent = parents_.rbegin();
  Expr const *part = choice;
  for (; parent != parents_.rend(); ++parent) { // an arm of another `?:` has that one's use
    auto const *outer = dyn_cast<ConditionalOperator>(*parent);
    if (!isa<ParenExpr>(*parent) && !(outer && outer->getCond() != part)) break;
    part = cast<Expr>(*parent);
  }
  if (parent == parents_.rend()) return false;
  auto const *cast = dyn_cast<ImplicitCastExpr>(*parent);
  if (!cast || cast->getCastKind() != CK_IntegralToFloating || !Reals::is_double(cast->getType())) return false;
  return ++parent != parents_.rend() &&
         (isa<BinaryOperator>(*parent) || isa<DeclStmt>(*parent) || isa<ReturnStmt>(*parent));
}

// Whether the arm is a symbolic integer. A macro's argument may expand its conversion into the condition and the arms.
// `becomes_number`: the enclosing `?:` is converted to a number.
bool DecisionCollector::is_symbolic_integer(Expr const *arm, bool becomes_number) const {
  if (!arm->getType()->isIntegerType() || arm->isTypeDependent()) return false;
  if (auto const *inner = dyn_cast<ConditionalOperator>(Reals::spelled_integer(arm))) { // as choose_value has it
    bool const yes = is_symbolic_integer(inner->getTrueExpr(), becomes_number);
    bool const no = is_symbolic_integer(inner->getFalseExpr(), becomes_number);
    return yes != no || ((yes || becomes_number) && conditions_.classify(inner->getCond()).is_real);
  }
  return reals_.integer_depends(arm, [this](CastExpr const *cast) {
    auto const *written = dyn_cast<ExplicitCastExpr>(cast);
    if (!written) return reals_.keeps_integer(cast);
    TypeLoc const type = written->getTypeInfoAsWritten()->getTypeLoc().getUnqualifiedLoc();
    std::optional<Span> const span = map_.range(type.getSourceRange());
    return span && facts_.wraps.contains({*span, Use::integer, ""});
  });
}

bool DecisionCollector::is_lvalue_used(ConditionalOperator const *choice) const {
  if (!choice->isGLValue()) return false;
  Expr const *part = choice;
  for (auto parent = parents_.rbegin(); parent != parents_.rend(); ++parent) {
    if (auto const *cast = dyn_cast<ImplicitCastExpr>(*parent)) return cast->getCastKind() != CK_LValueToRValue;
    auto const *outer = dyn_cast<ConditionalOperator>(*parent);
    if (!isa<ParenExpr>(*parent) && !(outer && outer->getCond() != part)) return true;
    part = cast<Expr>(*parent);
  }
  return true;
}

void DecisionCollector::choose_value(ConditionalOperator const *choice) {
  seen_.insert(choice);
  Condition const condition = conditions_.classify(choice->getCond());
  std::optional<Site> const at = site(choice->getQuestionLoc(), choice->getCond());
  if (!at) return;
  bool const in_macro = !map_.sources().getSLocEntry(at->frame).isFile();
  bool const becomes = becomes_number(choice);
  bool const yes = is_symbolic_integer(choice->getTrueExpr(), becomes);
  bool const no = is_symbolic_integer(choice->getFalseExpr(), becomes);
  if (!condition.is_real && yes == no) {
    // The macro's text may be changed for other uses.
    if (in_macro && is_lvalue_used(choice) && !choice->isTypeDependent())
      refuse(*at, {choice->getQuestionLoc(), {ReasonId::choice_of_objects}});
    return;
  }
  if (!becomes && !yes && !no)
    return refuse(*at, {choice->getQuestionLoc(), {ReasonId::choice_of_type, choice->getType().getAsString()}});
  if (is_lvalue_used(choice)) return refuse(*at, {choice->getQuestionLoc(), {ReasonId::choice_as_object}});
  std::optional<Span> const span = condition_span(*at, condition);
  if (!span) return;
  Allowed const allowed{.frame = at->frame};
  Arms const arms = analysis_.arms({choice->getTrueExpr(), choice->getFalseExpr()}, allowed);
  if (arms.blocker) return refuse(*at, *arms.blocker);
  if (!arms.targets.empty())
    return refuse(*at, {choice->getQuestionLoc(), {ReasonId::assignment_in_choice, "'" + arms.targets[0] + "'"}});
  std::optional<Span> const whole = map_.range_in(at->frame, choice->getSourceRange());
  std::optional<Alteration> const question =
      replacing(at->frame, {choice->getQuestionLoc(), choice->getQuestionLoc()}, "SYMREAL_REAL_THEN");
  std::optional<Alteration> const colon =
      replacing(at->frame, {choice->getColonLoc(), choice->getColonLoc()}, "SYMREAL_REAL_ELSE");
  if (!whole || !question || !colon || whole->begin > span->begin || span->end > question->span.begin ||
      question->span.end > colon->span.begin || colon->span.end >= whole->end)
    return refuse(*at, {choice->getQuestionLoc(), {ReasonId::choice_in_parts}});
  std::vector<Alteration> alterations = condition.joints;
  alterations.push_back({*span, "SYMREAL_REAL_COND(", ")"});
  alterations.push_back(*question);
  alterations.push_back(*colon);
  alterations.push_back({*whole, "", " SYMREAL_REAL_END", false, true});
  accept(*at, std::move(alterations));
}

void DecisionCollector::check_use_of_macro(ConditionalOperator const *choice) {
  if (seen_.count(choice) != 0 || choice->isInstantiationDependent() || !choice->getQuestionLoc().isMacroID()) return;
  std::optional<Span> const key = map_.token(choice->getQuestionLoc());
  if (!key) return;
  note({*key, map_.frame(choice->getQuestionLoc()), choice->getCond()->getSourceRange()},
       {choice->getQuestionLoc(), {ReasonId::used_outside}}, facts_.decisions[*key].misuses);
}

} // namespace symreal::rewrite
