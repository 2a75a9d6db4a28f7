#include "rewrite/source/token_watch.h"

#include "engine/support/files.h"
#include "engine/support/installation.h"
#include "rewrite/source/arithmetic.h"

#include <sstream>

namespace symreal::rewrite {
namespace {

using namespace clang;

// The short names of the macros in a rewritten source, which are those that the header defines.
llvm::StringSet<> const &short_names() {
  static llvm::StringSet<> const names = [] {
    llvm::StringSet<> found;
    std::istringstream header(read_file(runtime_include() + "/symreal/real.h"));
    for (std::string line; std::getline(header, line);)
      if (llvm::StringRef rest = line; rest.consume_front("#define ")) found.insert(rest.split(' ').first);
    internal_check(found.contains(usual_type_name));
    return found;
  }();
  return names;
}

class Names {
public:
  Names(SourceMap const &map, std::string const &type_name, Facts &facts)
      : map_(map),
        type_name_(type_name),
        facts_(facts) {}

  // Short names count wherever they are used, since the macros would be there too.
  void note(llvm::StringRef name, SourceLocation location) const {
    bool const reserved = name.starts_with("SYMREAL_");
    if (!reserved && name != type_name_ && !short_names_.contains(name)) return;
    if (reserved && !map_.in_roots(location)) return;
    symreal::Place place = map_.place(location);
    if (!is_own_header(place.file)) facts_.taken_names.try_emplace(name.str(), std::move(place));
  }

private:
  SourceMap const &map_;
  std::string const &type_name_;
  llvm::StringSet<> const &short_names_ = short_names();
  Facts &facts_;
};

// Notes macro names at their definitions, and where the program tests that they are undefined.
class MacroNames : public PPCallbacks {
public:
  explicit MacroNames(Names const &names) : names_(names) {}
  void MacroDefined(Token const &name, MacroDirective const *) override { note(name); }
  void Ifdef(SourceLocation, Token const &name, MacroDefinition const &) override { note(name); }
  void Ifndef(SourceLocation, Token const &name, MacroDefinition const &) override { note(name); }
  void Defined(Token const &name, MacroDefinition const &, SourceRange) override { note(name); }

private:
  void note(Token const &name) const { names_.note(name.getIdentifierInfo()->getName(), name.getLocation()); }
  Names const names_;
};

// Notes a token of a C source that must be renamed.
void note_keyword_name(Token const &token, SourceMap const &map, Facts &facts) {
  llvm::StringRef const name = token.getIdentifierInfo()->getName();
  if (!is_renamed(name) || map.is_argument_of(token.getLocation(), "REAL_NAME")) return;
  // A name that a macro pasted together has no place in a file; its declaration is reported.
  if (std::optional<Span> const span = map.token(token.getLocation(), name))
    facts.wraps.insert({*span, Use::name, name.str()});
}

// Before C99 `x //* half */ 2` is a division and a comment; later it is a comment alone.
void note_division(Token const &token, SourceMap const &map, Facts &facts) {
  char const *const text = map.sources().getCharacterData(map.sources().getSpellingLoc(token.getLocation()));
  if (text[0] != '/' || text[1] != '/') return;
  if (std::optional<Span> const first = map.first_character(token.getLocation()))
    facts.wraps.insert({*first, Use::division, ""});
}

} // namespace

bool is_keyword_of_cpp(llvm::StringRef name) {
  static llvm::StringSet<> const keywords = {
      "alignas",   "alignof",   "and",      "bool",          "catch",     "class",     "compl",       "concept",
      "constexpr", "decltype",  "delete",   "explicit",      "export",    "false",     "friend",      "mutable",
      "namespace", "new",       "noexcept", "not",           "nullptr",   "operator",  "or",          "private",
      "protected", "public",    "requires", "template",      "this",      "throw",     "true",        "try",
      "typeid",    "typename",  "using",    "virtual",       "wchar_t",   "xor",       "char16_t",    "char32_t",
      "co_await",  "co_return", "co_yield", "static_assert", "consteval", "constinit", "thread_local"};
  return keywords.contains(name);
}

bool is_renamed(llvm::StringRef name) {
  return is_keyword_of_cpp(name) && name != "wchar_t" && name != "char16_t" && name != "char32_t";
}

void watch_tokens(Preprocessor &preprocessor, SourceMap const &map, std::string const &type_name, Facts &facts,
                  ExpansionText &expansions) {
  Names const names(map, type_name, facts);
  preprocessor.addPPCallbacks(std::make_unique<MacroNames>(names));
  preprocessor.addPPCallbacks(make_arithmetic_pragma_watch(map, facts));
  preprocessor.setTokenWatcher(
      [&map, &facts, &expansions, names, attributes = ArithmeticAttributes(map, facts)](Token const &token) mutable {
        expansions.token(token);
        attributes.token(token);
        if (std::optional<Span> const first = map.first_character(token.getLocation())) {
          std::vector<bool> &reached = facts.reached[first->file];
          if (reached.size() < first->end) reached.resize(first->end);
          reached[first->begin] = true;
        }
        if (token.is(tok::kw_double)) {
          if (std::optional<Span> const span = map.token(token.getLocation()))
            note(facts.types, *span, {Fate::follows});
        } else if (token.is(tok::identifier)) {
          names.note(token.getIdentifierInfo()->getName(), token.getLocation());
          if (!map.language().CPlusPlus20) note_keyword_name(token, map, facts);
        } else if (token.is(tok::slash) && !map.language().LineComment) {
          note_division(token, map, facts);
        }
      });
}

} // namespace symreal::rewrite
