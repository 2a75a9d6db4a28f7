#include "rewrite/select/decision_collector.h"

#include "rewrite/source/walk.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

class ReturnStatements : public Walk {
public:
  bool TraverseLambdaExpr(LambdaExpr *) override { return true; }
  bool TraverseCXXRecordDecl(CXXRecordDecl *) override { return true; }
  bool VisitReturnStmt(ReturnStmt *statement) override {
    found.push_back(statement);
    return true;
  }
  std::vector<ReturnStmt const *> found;
};

} // namespace

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
  ReturnStatements returns;
  returns.TraverseStmt(function_->getBody());
  for (ReturnStmt const *one : returns.found) {
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
  returns_->blocker = analysis_.body(function_, ArmAnalysis::Part::after_returns);
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

} // namespace symreal::rewrite
