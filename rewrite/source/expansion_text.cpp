#include "rewrite/source/expansion_text.h"

namespace symreal::rewrite {
using namespace clang;

void ExpansionText::want(SourceLocation location) {
  CharSourceRange const invocation = map_.sources().getExpansionRange(location);
  texts_.try_emplace(invocation.getBegin(), Text{invocation, {}});
}

void ExpansionText::token(Token const &token) {
  if (texts_.empty() || !token.getLocation().isMacroID()) return;
  auto const found = texts_.find(map_.sources().getExpansionLoc(token.getLocation()));
  if (found == texts_.end() || token.isAnnotation()) return;
  std::string &tokens = found->second.tokens;
  if (!tokens.empty()) tokens += ' ';
  tokens += Lexer::getSpelling(token, map_.sources(), map_.language());
}

void ExpansionText::collect(Facts &facts) const {
  for (auto const &[begin, text] : texts_)
    if (std::optional<Span> const span = map_.range(text.invocation.getAsRange()))
      facts.wraps.insert({*span, Use::pasted, text.tokens});
}

} // namespace symreal::rewrite
