#include "engine/support/items.h"

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

} // namespace symreal
