#include "tool/configuration/yaml_fix.h"

#include "support/quoted.h"

#include <vector>

namespace symreal::tool {
namespace {

std::string trimmed(std::string const &text) {
  std::size_t const first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == text.npos ? "" : text.substr(first, last - first + 1);
}

// A word of ours that YAML takes for something else: a list, an alias, an anchor, a comment.
bool wants_quotes(std::string const &item) {
  if (item.empty() || item.front() == '"' || item.front() == '\'') return false;
  return item.front() == '*' || item.front() == '&' || item.front() == '%' || item.front() == '@' ||
         item.find_first_of("[]{}#") != item.npos;
}

// The items between the outermost brackets.
std::vector<std::string> items_of(std::string const &list) {
  std::vector<std::string> items(1);
  int depth = 0;
  for (char const c : list) {
    depth += c == '[' || c == '(' || c == '{' ? 1 : c == ']' || c == ')' || c == '}' ? -1 : 0;
    if (c == ',' && depth == 0)
      items.emplace_back();
    else
      items.back() += c;
  }
  for (std::string &item : items) item = trimmed(item);
  return items;
}

// A value, or a list of them in brackets.
std::string value_with_quotes(std::string const &value) {
  if (!value.starts_with("[")) return wants_quotes(value) ? in_quotes(value) : value;
  bool const is_closed = value.ends_with("]");
  std::string text = "[", before;
  for (std::string const &item : items_of(value.substr(1, value.size() - (is_closed ? 2 : 1)))) {
    text += before + (wants_quotes(item) ? in_quotes(item) : item);
    before = ", ";
  }
  return text + "]";
}

} // namespace

std::string with_quotes(std::string const &line) {
  std::size_t const key = line.find(": ");
  std::size_t const dash = line.find_first_not_of(' ');
  std::size_t begin = key != line.npos ? key + 2 : 0;
  if (key == line.npos && dash != line.npos && line.compare(dash, 2, "- ") == 0) begin = dash + 2;
  std::string const value = trimmed(line.substr(begin));
  std::string const fixed = value_with_quotes(value);
  return fixed == value ? "" : trimmed(line.substr(0, begin)) + " " + fixed;
}

} // namespace symreal::tool
