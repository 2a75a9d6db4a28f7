#include "rewrite/token_watch.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

void refuse_reserved(llvm::StringRef name, SourceLocation location, SourceMap const &map, Facts &facts) {
  if (name != "REAL" && !name.starts_with("REAL_") && !name.starts_with("SYMREAL_")) return;
  if (!map.in_roots(location)) return;
  for (symreal::Diagnostic const &known : facts.diagnostics)
    if (known.id == DiagnosticId::reserved_name && known.message.find("'" + name.str() + "'") == 0) return;
  facts.diagnostics.push_back({DiagnosticId::reserved_name, Severity::error, map.place(location),
                               "'" + name.str() + "' is a name of the source already"});
}

class MacroNames : public PPCallbacks {
public:
  MacroNames(SourceMap const &map, Facts &facts) : map_(map), facts_(facts) {}
  void MacroDefined(Token const &name, MacroDirective const *) override {
    refuse_reserved(name.getIdentifierInfo()->getName(), name.getLocation(), map_, facts_);
  }

private:
  SourceMap const &map_;
  Facts &facts_;
};

} // namespace

void watch_tokens(Preprocessor &preprocessor, SourceMap const &map, Facts &facts, ExpansionText &expansions) {
  preprocessor.addPPCallbacks(std::make_unique<MacroNames>(map, facts));
  preprocessor.setTokenWatcher([&map, &facts, &expansions](Token const &token) {
    expansions.token(token);
    if (std::optional<Span> const first = map.first_character(token.getLocation())) {
      std::vector<bool> &reached = facts.reached[first->file];
      if (reached.size() < first->end) reached.resize(first->end);
      reached[first->begin] = true;
    }
    if (token.is(tok::kw_double)) {
      if (std::optional<Span> const span = map.token(token.getLocation())) facts.doubles.insert(*span);
    } else if (token.is(tok::identifier))
      refuse_reserved(token.getIdentifierInfo()->getName(), token.getLocation(), map, facts);
  });
}

} // namespace symreal::rewrite
