#include "tool/configuration/yaml_fix.h"

#include "engine/support/items.h"
#include "engine/support/quoted.h"

namespace symreal::tool {
namespace {

// Does the item need quotes, since YAML takes it for a list, an alias, an anchor or a comment?
bool wants_quotes(std::string const &item) {
  if (item.empty() || item.front() == '"' || item.front() == '\'') return false;
  return item.front() == '*' || item.front() == '&' || item.front() == '%' || item.front() == '@' ||
         item.find_first_of("[]{}#") != item.npos;
}

// Quotes a value, or the values of a bracketed list.
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
  std::string const value(trimmed(line.substr(begin)));
  std::string const fixed = value_with_quotes(value);
  return fixed == value ? "" : std::string(trimmed(line.substr(0, begin))) + " " + fixed;
}

} // namespace symreal::tool
