// Patterns: text with placeholders in the language tables, such as "$type $name = $value;".
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace symreal {

// The pattern with each $name replaced by the text that `find` returns for it; nullopt from `find` is a fault of the
// table.
template <class Find> std::string fill_places(std::string_view pattern, Find const &find) {
  auto const is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  std::string text;
  while (true) {
    std::size_t const dollar = std::min(pattern.find('$'), pattern.size());
    text += pattern.substr(0, dollar);
    if (dollar == pattern.size()) return text;
    pattern.remove_prefix(dollar + 1);
    if (pattern.starts_with('$')) {
      text += '$';
      pattern.remove_prefix(1);
      continue;
    }
    bool const braced = pattern.starts_with('{');
    if (braced) pattern.remove_prefix(1);
    auto const length = static_cast<std::size_t>(std::ranges::find_if_not(pattern, is_letter) - pattern.begin());
    std::optional<std::string_view> const value = find(pattern.substr(0, length));
    internal_check(value && (!braced || pattern.substr(length).starts_with('}')));
    text += *value;
    pattern.remove_prefix(length + (braced ? 1 : 0));
  }
}

// Value for the name in a list of pairs; nullopt if absent.
inline std::optional<std::string_view> find_place(std::span<std::pair<std::string_view, std::string_view> const> values,
                                                  std::string_view name) {
  for (auto const &[given, value] : values)
    if (given == name) return value;
  return std::nullopt;
}

// Replaces each $name, or ${name} before a letter, by its value, and $$ by $. A name without a value is a fault of the
// table.
std::string fill(std::string_view pattern, std::span<std::pair<std::string_view, std::string_view> const> values);
inline std::string fill(std::string_view pattern,
                        std::initializer_list<std::pair<std::string_view, std::string_view>> values) {
  return fill(pattern, std::span(values.begin(), values.size()));
}

// A reusable set of values, whose names have three cases: name, Name, NAME.
class Filling {
public:
  Filling &set(std::string const &name, std::string value) {
    values_.insert_or_assign(name, std::move(value));
    return *this;
  }
  Filling &set(std::string const &name, std::size_t value) { return set(name, std::to_string(value)); }
  // `joins`: whether a_name becomes AName instead of A_name.
  Filling &set_name(std::string const &name, std::string const &value, bool joins = true);
  std::string operator()(std::string_view pattern) const;

private:
  std::map<std::string, std::string> values_;
};

} // namespace symreal
