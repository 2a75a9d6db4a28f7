#include "rewrite/keyword_names.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

// Does the token stand in REAL_NAME(...), from the rewriting before?
bool is_renamed_already(SourceLocation location, SourceMap const &map) {
  SourceManager const &sources = map.sources();
  for (; sources.isMacroArgExpansion(location); location = sources.getImmediateSpellingLoc(location)) {
    SourceLocation const parameter = sources.getImmediateExpansionRange(location).getBegin();
    if (Lexer::getImmediateMacroName(parameter, sources, map.language()).ends_with("REAL_NAME")) return true;
  }
  return false;
}

} // namespace

bool is_keyword_of_cpp(llvm::StringRef name) {
  static llvm::StringSet<> const keywords = {
      "alignas",  "alignof", "and",      "bool",     "catch",    "class",     "compl",     "concept",      "constexpr",
      "decltype", "delete",  "explicit", "export",   "false",    "friend",    "mutable",   "namespace",    "new",
      "noexcept", "not",     "nullptr",  "operator", "or",       "private",   "protected", "public",       "requires",
      "template", "this",    "throw",    "true",     "try",      "typeid",    "typename",  "using",        "virtual",
      "wchar_t",  "xor",     "char16_t", "char32_t", "co_await", "co_return", "co_yield",  "static_assert"};
  return keywords.contains(name);
}

bool is_renamed(llvm::StringRef name) {
  return is_keyword_of_cpp(name) && name != "wchar_t" && name != "char16_t" && name != "char32_t";
}

void note_keyword_name(Token const &token, SourceMap const &map, Facts &facts) {
  llvm::StringRef const name = token.getIdentifierInfo()->getName();
  if (!is_renamed(name) || is_renamed_already(token.getLocation(), map)) return;
  // What a macro pasted together stands nowhere; the declaration is reported.
  std::optional<Span> const span = map.token(token.getLocation());
  if (span && map.text(*span, token.getLocation()) == name) facts.wraps.insert({*span, Use::name, name.str()});
}

} // namespace symreal::rewrite
