#include "rewrite/quoted_arguments.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

class Recorder : public PPCallbacks {
public:
  Recorder(SourceMap const &map, Facts &facts) : map_(map), facts_(facts) {}

  void MacroExpands(Token const &, MacroDefinition const &definition, SourceRange,
                    MacroArgs const *arguments) override {
    MacroInfo const *macro = definition.getMacroInfo();
    if (!arguments || !macro) return;
    llvm::ArrayRef<Token> const body = macro->tokens();
    for (std::size_t i = 0; i < body.size(); ++i) {
      if (!body[i].getIdentifierInfo()) continue;
      int const parameter = macro->getParameterNum(body[i].getIdentifierInfo());
      if (parameter < 0) continue;
      bool const after = i > 0 && body[i - 1].isOneOf(tok::hash, tok::hashhash, tok::hashat);
      bool const before = i + 1 < body.size() && body[i + 1].is(tok::hashhash);
      if (!after && !before) continue;
      Token const *token = arguments->getUnexpArgument(static_cast<unsigned>(parameter));
      for (; token && token->isNot(tok::eof); ++token)
        if (std::optional<Span> const span = map_.token(token->getLocation())) facts_.quoted.insert(*span);
    }
  }

private:
  SourceMap const &map_;
  Facts &facts_;
};

} // namespace

std::unique_ptr<PPCallbacks> make_quoted_argument_recorder(SourceMap const &map, Facts &facts) {
  return std::make_unique<Recorder>(map, facts);
}

} // namespace symreal::rewrite
