#include "rewrite/text/source_text.h"

#include "rewrite/request/request.h"

#include <algorithm>
#include <cctype>

namespace symreal::rewrite {
namespace {

std::string without_comments(std::string const &source) {
  std::string text;
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (source.compare(i, 2, "//") == 0) {
      while (i < source.size() && source[i] != '\n') ++i;
      text += '\n';
    } else if (source.compare(i, 2, "/*") == 0) {
      std::size_t const end = source.find("*/", i + 2);
      i = end == std::string::npos ? source.size() : end + 1;
      text += ' ';
    } else
      text += source[i];
  }
  return text;
}

} // namespace

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

std::string trimmed(std::string text) {
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

std::string normalised(std::string const &source) {
  std::string text;
  for (char c : without_comments(source)) {
    if (!std::isspace(static_cast<unsigned char>(c)))
      text += c;
    else if (!text.empty() && text.back() != ' ')
      text += ' ';
  }
  return trimmed(text);
}

bool only_declaration_start(std::string const &source) {
  std::string const text = without_comments(source);
  bool at_line_start = true;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '#' && at_line_start)
      while (i < text.size() && text[i] != '\n') i += text[i] == '\\' ? 2 : 1;
    if (i >= text.size()) break;
    if (text[i] == ';' || text[i] == '{' || text[i] == '}') return false;
    if (text[i] == '\n')
      at_line_start = true;
    else if (!std::isspace(static_cast<unsigned char>(text[i])))
      at_line_start = false;
  }
  return true;
}

std::string with_real(std::string const &source) {
  std::string text;
  std::string previous;
  for (std::size_t i = 0; i < source.size();) {
    if (!is_word(source[i])) {
      text += source[i++];
      continue;
    }
    std::size_t end = i;
    while (end < source.size() && is_word(source[end])) ++end;
    std::string const word = source.substr(i, end - i);
    text += word == "double" && previous != "long" ? reserved_type_name : word;
    previous = word;
    i = end;
  }
  return text;
}

} // namespace symreal::rewrite
