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

namespace {

class QuotedArguments : public PPCallbacks {
public:
  QuotedArguments(SourceMap const &map, Facts &facts, ExpansionText &expansions)
      : map_(map),
        facts_(facts),
        expansions_(expansions) {}

  void MacroExpands(Token const &name, MacroDefinition const &definition, SourceRange range,
                    MacroArgs const *arguments) override {
    MacroInfo const *macro = definition.getMacroInfo();
    if (!arguments || !macro) return;
    llvm::ArrayRef<Token> const body = macro->tokens();
    for (std::size_t i = 0; i < body.size(); ++i) {
      if (!body[i].getIdentifierInfo()) continue;
      int const parameter = macro->getParameterNum(body[i].getIdentifierInfo());
      if (parameter < 0) continue;
      bool const is_text = i > 0 && body[i - 1].isOneOf(tok::hash, tok::hashat);
      // #x ## _suffix pastes the text.
      bool const is_pasted = !is_text && ((i > 0 && body[i - 1].is(tok::hashhash)) ||
                                          (i + 1 < body.size() && body[i + 1].is(tok::hashhash)));
      if (!is_text && !is_pasted) continue;
      if (is_text) call(range);
      Token const *token = arguments->getUnexpArgument(static_cast<unsigned>(parameter));
      for (; token && token->isNot(tok::eof); ++token) quote(name, *token, is_pasted);
    }
  }

private:
  void quote(Token const &macro, Token const &token, bool is_pasted) {
    if (token.is(tok::kw_double) && is_from_body(token.getLocation()))
      expansions_.want(macro.getLocation(), is_pasted ? ExpansionText::For::words : ExpansionText::For::strings);
    else if (std::optional<Span> const span = map_.token(token.getLocation())) {
      facts_.quoted.insert(*span);
      if (is_pasted) facts_.pasted.insert(*span);
    }
  }

  // The outermost call, where that stands in the text of a file.
  void call(SourceRange range) {
    CharSourceRange const outermost = map_.sources().getExpansionRange(range);
    if (std::optional<Span> const span = map_.range(outermost.getAsRange())) facts_.text_calls.insert(*span);
  }

  // Whether the token comes from a macro's expansion within a forwarded argument.
  bool is_from_body(SourceLocation location) const {
    SourceManager const &sources = map_.sources();
    bool handed_down = false;
    while (location.isMacroID()) {
      if (!sources.isMacroArgExpansion(location)) return handed_down;
      handed_down = true;
      location = sources.getImmediateSpellingLoc(location);
    }
    return false;
  }

  SourceMap const &map_;
  Facts &facts_;
  ExpansionText &expansions_;
};

} // namespace

std::unique_ptr<PPCallbacks> make_quoted_argument_collector(SourceMap const &map, Facts &facts,
                                                            ExpansionText &expansions) {
  return std::make_unique<QuotedArguments>(map, facts, expansions);
}

} // namespace symreal::rewrite
