#include "rewrite/select/decisions.h"

#include "rewrite/source/walk.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

// The functions with code that is compiled: templates as they are instantiated.
class Functions : public Walk {
public:
  explicit Functions(SourceMap const &map) : map_(map) {}
  bool shouldVisitTemplateInstantiations() const override { return true; }

  std::vector<FunctionDecl const *> found;
  std::vector<ConditionalOperator const *> choices;

  bool TraverseDecl(Decl *declaration) override {
    if (!declaration || map_.is_outside(declaration)) return true;
    return Walk::TraverseDecl(declaration);
  }
  bool VisitFunctionDecl(FunctionDecl *function) override {
    bool const is_code = function->doesThisDeclarationHaveABody() && !function->isImplicit();
    if (is_code && map_.in_roots(function->getLocation())) found.push_back(function);
    return true;
  }
  bool VisitConditionalOperator(ConditionalOperator *choice) override {
    choices.push_back(choice);
    return true;
  }

private:
  SourceMap const &map_;
};

// A macro's argument must not hold a directive.
bool has_directive(std::string const &text) {
  for (std::size_t line = text.find('\n'); line != std::string::npos; line = text.find('\n', line + 1)) {
    std::size_t const first = text.find_first_not_of(" \t", line + 1);
    if (first != std::string::npos && text[first] == '#') return true;
  }
  return false;
}

constexpr std::size_t longest = 120;

std::string on_one_line(llvm::StringRef text) {
  std::string result;
  for (char const c : text) {
    bool const blank = c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\\';
    if (!blank)
      result += c;
    else if (!result.empty() && result.back() != ' ')
      result += ' ';
  }
  if (result.size() > longest) result.replace(longest, result.npos, "...");
  return result;
}

} // namespace

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
  } else if (!isa<CXXDefaultArgExpr>(statement)) { // which is written elsewhere
    for (Stmt const *child : statement->children()) walk(child);
  }
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
    Condition const condition = conditions_.classify(inner->getCond());
    if (condition.blocker) return yes && no; // it stays a `?:`, of plain integers if one is plain
    return yes != no || ((yes || becomes_number) && condition.is_real);
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
  bool const becomes = becomes_number(choice);
  bool const yes = is_symbolic_integer(choice->getTrueExpr(), becomes);
  bool const no = is_symbolic_integer(choice->getFalseExpr(), becomes);
  if (select_value(choice, becomes, yes, no)) return;
  if (yes != no) return make_plain(yes ? choice->getTrueExpr() : choice->getFalseExpr());
  counted_arms(choice);
}

// An arm that counts truth values of numbers, in a `?:` that stays one: in another instantiation it may be a number.
void DecisionCollector::counted_arms(ConditionalOperator const *choice) {
  if (!choice->getType()->isIntegerType() || choice->isTypeDependent()) return;
  Expr const *yes = Reals::spelled_integer(choice->getTrueExpr()), *no = Reals::spelled_integer(choice->getFalseExpr());
  auto const counts = [this](Expr const *arm) { return isa<BinaryOperator>(arm) && reals_.may_be_symbolic(arm); };
  bool const are_one_type = context_.hasSameUnqualifiedType(yes->getType(), no->getType());
  for (auto const &[arm, other] : {std::pair(yes, no), std::pair(no, yes)})
    if (counts(arm) && !reals_.is_symbolic_integer(arm) && !(counts(other) && are_one_type))
      if (std::optional<Span> const span = map_.range(arm->getSourceRange()); span && map_.in_roots(arm->getBeginLoc()))
        facts_.wraps.insert({*span, Use::erased, ""});
}

// An integer cannot be an alternative to a symbolic one, such as a `?:` that has become a select.
void DecisionCollector::make_plain(Expr const *arm) {
  auto const *inner = dyn_cast<ConditionalOperator>(Reals::spelled_integer(arm));
  std::optional<Span> const span = inner ? map_.range(inner->getSourceRange()) : std::nullopt;
  if (!span || !map_.in_roots(inner->getBeginLoc())) return;
  PrintingPolicy const policy(map_.language());
  facts_.wraps.insert({*span, Use::conversion, inner->getType().getUnqualifiedType().getAsString(policy)});
}

// Whether the choice can become a select. `yes`, `no`: whether the arms are symbolic integers.
bool DecisionCollector::select_value(ConditionalOperator const *choice, bool becomes, bool yes, bool no) {
  Condition const condition = conditions_.classify(choice->getCond());
  std::optional<Site> const at = site(choice->getQuestionLoc(), choice->getCond());
  if (!at) return false;
  auto const refuse_at = [&](Blocker const &blocker) {
    refuse(*at, blocker);
    return false;
  };
  bool const in_macro = !map_.sources().getSLocEntry(at->frame).isFile();
  if (!condition.is_real && yes == no) {
    // The macro's text may be changed for other uses.
    if (in_macro && is_lvalue_used(choice) && !choice->isTypeDependent())
      refuse(*at, {choice->getQuestionLoc(), {ReasonId::choice_of_objects}});
    return false;
  }
  if (!becomes && !yes && !no)
    return refuse_at({choice->getQuestionLoc(), {ReasonId::choice_of_type, choice->getType().getAsString()}});
  if (is_lvalue_used(choice)) return refuse_at({choice->getQuestionLoc(), {ReasonId::choice_as_object}});
  std::optional<Span> const span = condition_span(*at, condition);
  if (!span) return false;
  Allowed const allowed{.frame = at->frame};
  Arms const arms = analysis_.arms({choice->getTrueExpr(), choice->getFalseExpr()}, allowed);
  if (arms.blocker) return refuse_at(*arms.blocker);
  if (!arms.targets.empty())
    return refuse_at({choice->getQuestionLoc(), {ReasonId::assignment_in_choice, "'" + arms.targets[0] + "'"}});
  std::optional<Span> const whole = map_.range_in(at->frame, choice->getSourceRange());
  std::optional<Alteration> const question =
      replacing(at->frame, {choice->getQuestionLoc(), choice->getQuestionLoc()}, "SYMREAL_REAL_THEN");
  std::optional<Alteration> const colon =
      replacing(at->frame, {choice->getColonLoc(), choice->getColonLoc()}, "SYMREAL_REAL_ELSE");
  if (!whole || !question || !colon || whole->begin > span->begin || span->end > question->span.begin ||
      question->span.end > colon->span.begin || colon->span.end >= whole->end)
    return refuse_at({choice->getQuestionLoc(), {ReasonId::choice_in_parts}});
  std::vector<Alteration> alterations = condition.joints;
  alterations.push_back({*span, "SYMREAL_REAL_COND(", ")"});
  alterations.push_back(*question);
  alterations.push_back(*colon);
  alterations.push_back({*whole, "", " SYMREAL_REAL_END", false, true});
  accept(*at, std::move(alterations));
  return true;
}

void DecisionCollector::check_use_of_macro(ConditionalOperator const *choice) {
  if (seen_.count(choice) != 0 || choice->isInstantiationDependent() || !choice->getQuestionLoc().isMacroID()) return;
  std::optional<Span> const key = map_.token(choice->getQuestionLoc());
  if (!key) return;
  note({*key, map_.frame(choice->getQuestionLoc()), choice->getCond()->getSourceRange()},
       {choice->getQuestionLoc(), {ReasonId::used_outside}}, facts_.decisions[*key].misuses);
}

// The source texts of decided values, which messages about decisions quote.
void DecisionCollector::deciding(SourceLocation keyword, Expr const *value) {
  if (value) deciding(keyword, value->getSourceRange(), value, {});
}

void DecisionCollector::converting(CastExpr const *cast) {
  // An explicit cast `(int)x` contains the conversion as a part without text.
  auto const *part = dyn_cast<ImplicitCastExpr>(cast->getSubExpr());
  CastExpr const *conversion = part && part->getCastKind() == CK_FloatingToIntegral ? part : cast;
  if (conversion->getCastKind() == CK_FloatingToIntegral)
    deciding({}, cast->getSourceRange(), conversion->getSubExpr(),
             cast->getType().getUnqualifiedType().getAsString(map_.language()));
}

void DecisionCollector::deciding(SourceLocation keyword, SourceRange where, Expr const *value, std::string type) {
  if (!map_.in_roots(where.getBegin())) return;
  SourceManager const &sources = map_.sources();
  SourceRange const range = value->getSourceRange();
  CharSourceRange written = Lexer::makeFileCharRange(CharSourceRange::getTokenRange(range), sources, map_.language());
  if (written.isInvalid()) written = Lexer::getAsCharRange(sources.getExpansionRange(range), sources, map_.language());
  DecidingText found{{},
                     map_.place(where.getBegin()),
                     map_.place(where.getEnd()),
                     on_one_line(Lexer::getSourceText(written, sources, map_.language())),
                     std::move(type)};
  if (keyword.isValid()) found.keyword = map_.place(keyword);
  if (found.text.empty()) return;
  std::string key = to_string(found.begin) + " " + to_string(found.end) + " " + to_string(found.keyword) + found.type;
  facts_.deciding.try_emplace(std::move(key), std::move(found));
}

void DecisionCollector::note_deciding(Stmt const *statement) {
  if (auto const *choice = dyn_cast<IfStmt>(statement)) deciding(choice->getIfLoc(), choice->getCond());
  if (auto const *choice = dyn_cast<SwitchStmt>(statement)) deciding(choice->getSwitchLoc(), choice->getCond());
  if (auto const *choice = dyn_cast<ConditionalOperator>(statement))
    deciding(choice->getQuestionLoc(), choice->getCond());
  if (auto const *end = dyn_cast<ReturnStmt>(statement); end && end->getRetValue()) {
    Expr const *value = end->getRetValue()->IgnoreParenImpCasts();
    if (auto const *choice = dyn_cast<ConditionalOperator>(value)) deciding(end->getReturnLoc(), choice->getCond());
    if (auto const *test = dyn_cast<BinaryOperator>(value); test && (test->isComparisonOp() || test->isLogicalOp()))
      deciding(end->getReturnLoc(), test);
  }
  if (auto const *loop = dyn_cast<ForStmt>(statement)) deciding(loop->getForLoc(), loop->getCond());
  if (auto const *loop = dyn_cast<WhileStmt>(statement)) deciding(loop->getWhileLoc(), loop->getCond());
  if (auto const *loop = dyn_cast<DoStmt>(statement)) deciding(loop->getWhileLoc(), loop->getCond());
  if (auto const *operation = dyn_cast<BinaryOperator>(statement))
    if (operation->isComparisonOp() || operation->isLogicalOp()) deciding({}, operation);
  if (auto const *cast = dyn_cast<CastExpr>(statement)) converting(cast);
}

std::optional<Blocker> DecisionCollector::collect_returns(std::vector<Alteration> &alterations, Span &brace) const {
  auto const *body = dyn_cast<CompoundStmt>(function_->getBody());
  if (!body) return Blocker{function_->getLocation(), {ReasonId::return_of_try}};
  FileID const frame = map_.frame(body->getLBracLoc());
  std::optional<Span> const open = map_.range_in(frame, {body->getLBracLoc(), body->getLBracLoc()});
  std::optional<Span> const close = map_.range_in(frame, {body->getRBracLoc(), body->getRBracLoc()});
  if (!open || !close) return Blocker{body->getLBracLoc(), {ReasonId::return_of_macro_function}};
  brace = *open;
  alterations.push_back({*open, "", " SYMREAL_RETURNS"});
  alterations.push_back({*close, "SYMREAL_RETURNS_END ", ""});
  for (ReturnStmt const *one : returns_of(function_)) {
    Expr const *value = one->getRetValue();
    if (map_.frame(one->getReturnLoc()) != frame) return Blocker{one->getReturnLoc(), {ReasonId::return_by_macro}};
    std::optional<Span> const span = map_.range_in(frame, value->getSourceRange());
    std::optional<Alteration> word =
        replacing(frame, {one->getReturnLoc(), one->getReturnLoc()}, "SYMREAL_REAL_RETURN(");
    if (!span || !word || isa<InitListExpr>(value->IgnoreImplicit()))
      return Blocker{one->getReturnLoc(), {ReasonId::return_in_parts}};
    if (map_.text_in(frame, {word->span.file, word->span.end, span->begin}) == " ") word->span.end = span->begin;
    alterations.push_back(*word);
    alterations.push_back({*span, "", ")"});
  }
  return std::nullopt;
}

DecisionCollector::Returns const &DecisionCollector::early_returns() {
  if (returns_) return *returns_;
  returns_.emplace();
  std::vector<Alteration> alterations;
  returns_->blocker = analysis_.body(function_, ArmAnalysis::BodyPart::after_returns);
  if (returns_->blocker) {
    returns_->blocker->reason = {ReasonId::return_before, {}, {returns_->blocker->reason}};
    return *returns_;
  }
  returns_->blocker = collect_returns(alterations, returns_->brace);
  if (!returns_->blocker) {
    DecisionFact &fact = facts_.decisions[returns_->brace];
    if (fact.alterations.empty()) fact.alterations = std::move(alterations);
  }
  return *returns_;
}

void collect_decisions(ASTContext &context, SourceMap const &map, Reals const &reals, PragmaIndex const &index,
                       Facts &facts) {
  Functions functions(map);
  functions.TraverseDecl(context.getTranslationUnitDecl());
  DecisionCollector collector(context, map, reals, index, facts);
  for (FunctionDecl const *function : functions.found) collector.function(function);
  collector.check_pragmas();
  // A macro's body is one text for all of its uses.
  for (ConditionalOperator const *choice : functions.choices) collector.check_use_of_macro(choice);
}

} // namespace symreal::rewrite
