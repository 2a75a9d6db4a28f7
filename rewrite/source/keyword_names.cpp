#include "rewrite/source/keyword_names.h"

namespace symreal::rewrite {
using namespace clang;

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

void note_keyword_name(Token const &token, SourceMap const &map, Facts &facts) {
  llvm::StringRef const name = token.getIdentifierInfo()->getName();
  if (!is_renamed(name) || map.is_argument_of(token.getLocation(), "REAL_NAME")) return;
  // A name that a macro pasted together has no place in a file; its declaration is reported.
  if (std::optional<Span> const span = map.token(token.getLocation(), name))
    facts.wraps.insert({*span, Use::name, name.str()});
}

} // namespace symreal::rewrite
