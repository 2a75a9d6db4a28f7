#include "rewrite/source/quoted_arguments.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

class Collector : public PPCallbacks {
public:
  Collector(SourceMap const &map, Facts &facts, ExpansionText &expansions)
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
  return std::make_unique<Collector>(map, facts, expansions);
}

} // namespace symreal::rewrite
