#include "rewrite/scan_text.h"

#include <algorithm>
#include <cctype>

namespace symreal::rewrite {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::size_t end_of_literal(std::string const &text, std::size_t begin) {
  std::size_t at = begin + 1;
  while (at < text.size() && text[at] != text[begin]) at += text[at] == '\\' ? 2 : 1;
  return std::min(at + 1, text.size());
}

std::size_t closing_parenthesis(std::string const &text, std::size_t open) {
  int depth = 0;
  for (std::size_t at = open; at < text.size();) {
    char const c = text[at];
    if (c == ')' && --depth == 0) return at;
    if (c == '(') ++depth;
    at = c == '"' || c == '\'' ? end_of_literal(text, at) : at + 1;
  }
  return text.npos;
}

} // namespace symreal::rewrite
