// Source texts of decided values, which messages about decisions quote.
#include "rewrite/select/decision_collector.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

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

} // namespace symreal::rewrite
