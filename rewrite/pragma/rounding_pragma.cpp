#include "rewrite/pragma/rounding_pragma.h"

#include "rewrite/facts/merge.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

class Watch : public PPCallbacks {
public:
  Watch(SourceMap const &map, Facts &facts) : map_(map), facts_(facts) {}

  // Whether the compiler knows the pragma or not, its text suffices here.
  void PragmaDirective(SourceLocation location, PragmaIntroducerKind) override {
    if (!map_.in_roots(location)) return;
    llvm::StringRef const rest = map_.sources().getCharacterData(map_.sources().getSpellingLoc(location));
    llvm::StringRef const line = rest.take_until([](char c) { return c == '\n'; });
    auto const [before, mode] = line.split("FENV_ROUND");
    if (mode.empty() || !before.contains("STDC")) return;
    llvm::StringRef const name = mode.ltrim().take_while([](char c) { return llvm::isAlnum(c) || c == '_'; });
    if (name == "FE_TONEAREST" || name == "FE_DYNAMIC") return;
    add_diagnostic(facts_, {DiagnosticId::arithmetic_modes, map_.place(location),
                            "FENV_ROUND " + name.str() + ": what is computed here does not round to nearest"});
  }

private:
  SourceMap const &map_;
  Facts &facts_;
};

} // namespace

std::unique_ptr<PPCallbacks> make_rounding_pragma_watch(SourceMap const &map, Facts &facts) {
  return std::make_unique<Watch>(map, facts);
}

} // namespace symreal::rewrite
