#include "engine/support/text.h"

namespace symreal {

std::string_view trimmed(std::string_view text) {
  constexpr char const *blank = " \t\r\n";
  std::size_t const begin = text.find_first_not_of(blank);
  return begin == text.npos ? std::string_view() : text.substr(begin, text.find_last_not_of(blank) + 1 - begin);
}

std::vector<std::string> items_of(std::string_view text) {
  std::vector<std::string> items(1);
  int depth = 0;
  for (char const c : text) {
    depth += (c == '[' || c == '(' || c == '{') - (c == ']' || c == ')' || c == '}');
    if (c == ',' && depth == 0)
      items.emplace_back();
    else
      items.back() += c;
  }
  for (std::string &item : items) item = trimmed(item);
  return items;
}

std::string escaped(std::string const &text) {
  std::string result;
  for (char const c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string in_quotes(std::string const &text) { return '"' + escaped(text) + '"'; }

std::string escaped_xml(std::string_view text) {
  std::string result;
  for (char const c : text)
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
  return result;
}

} // namespace symreal
