#include "engine/emit/language/toml.h"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>
#include <toml++/toml.h>
#include <utility>

namespace symreal {

void table_fault(std::string_view file, unsigned line, std::string const &what) {
  throw std::runtime_error(fmt::format("{}:{}: {}", file, line, what));
}

namespace {

TomlValue value_of(toml::node const &node, std::string_view file) {
  if (auto const *text = node.as_string()) return {text->get()};
  if (auto const *number = node.as_integer()) return {number->get()};
  if (auto const *truth = node.as_boolean()) return {truth->get()};
  auto const *array = node.as_array();
  if (!array)
    table_fault(file, node.source().begin.line, "a value is a text, a whole number, true, false or a list of these");
  TomlValue::List list;
  for (toml::node const &element : *array) list.push_back(value_of(element, file));
  return {std::move(list)};
}

void add_entries(toml::table const &table, std::string const &path, std::string_view file,
                 std::vector<std::pair<toml::source_position, TomlEntry>> &entries) {
  for (auto const &[key, node] : table) {
    std::string const whole = path + std::string(key.str());
    if (auto const *inner = node.as_table())
      add_entries(*inner, whole + ".", file, entries);
    else
      entries.push_back({key.source().begin, {whole, value_of(node, file), file, key.source().begin.line}});
  }
}

} // namespace

std::vector<TomlEntry> read_toml(std::string_view file, std::string_view text) try {
  std::vector<std::pair<toml::source_position, TomlEntry>> placed; // the library sorts tables by their keys
  add_entries(toml::parse(text, file), "", file, placed);
  std::ranges::sort(placed, {}, [](auto const &one) { return std::pair(one.first.line, one.first.column); });
  std::vector<TomlEntry> entries;
  for (auto &[position, entry] : placed) entries.push_back(std::move(entry));
  return entries;
} catch (toml::parse_error const &error) {
  table_fault(file, error.source().begin.line, std::string(error.description()));
}

} // namespace symreal
