#include "rewrite/source/expansion_text.h"

namespace symreal::rewrite {
using namespace clang;

void ExpansionText::want(SourceLocation location, For what) {
  CharSourceRange const invocation = map_.sources().getExpansionRange(location);
  Text &text = texts_.try_emplace(invocation.getBegin(), Text{invocation}).first->second;
  text.makes_words |= what == For::words;
}

void ExpansionText::token(Token const &token) {
  if (!token.getLocation().isMacroID() || token.isAnnotation()) return;
  SourceLocation const invocation = map_.sources().getExpansionLoc(token.getLocation());
  if (invocation != invocation_) finish();
  invocation_ = invocation;
  tokens_.push_back(token);
}

void ExpansionText::finish() {
  SourceManager const &sources = map_.sources();
  for (Token const &token : tokens_) {
    add(token, invocation_, {});
    // An invocation in an argument; the body may use the argument more than once.
    SourceLocation at = token.getLocation(), use;
    while (at.isMacroID()) {
      bool const is_argument = sources.isMacroArgExpansion(at);
      SourceLocation const outer = sources.getImmediateExpansionRange(at).getBegin();
      if (is_argument) use = outer;
      at = is_argument ? sources.getImmediateSpellingLoc(at) : outer;
    }
    if (at != invocation_) add(token, at, use);
  }
  tokens_.clear();
}

void ExpansionText::add(Token const &token, SourceLocation invocation, SourceLocation use) {
  auto const found = texts_.find(invocation);
  if (found == texts_.end()) return;
  Text &text = found->second;
  if (text.tokens.empty()) text.use = use;
  if (use != text.use) return;
  if (!text.tokens.empty()) text.tokens += ' ';
  text.tokens += Lexer::getSpelling(token, map_.sources(), map_.language());
  text.has_names |= token.getIdentifierInfo() != nullptr;
}

void ExpansionText::collect(Facts &facts) {
  finish();
  for (auto const &[begin, text] : texts_)
    if (std::optional<Span> const span = map_.range(text.invocation.getAsRange());
        span && (text.makes_words || !text.has_names))
      facts.wraps.insert({*span, Use::pasted, text.tokens});
}

} // namespace symreal::rewrite
