// Patterns: text with placeholders in the language tables, such as "$type $name = $value;". Each $name, or ${name}
// before a letter, stands for its value, and $$ for $. A name without a value is a fault of the table.
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace symreal {

struct Language; // language.h

// Length of the name at the beginning of the text.
inline std::size_t length_of_name(std::string_view text) {
  auto const is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return static_cast<std::size_t>(std::ranges::find_if_not(text, is_letter) - text.begin());
}

// a_name, AName and A_NAME.
std::array<std::string, 3> in_three_cases(std::string const &name);

// The pattern with each $name replaced by the text that `find` returns for it, or nullopt.
template <class Find> std::string fill_places(std::string_view pattern, Find const &find) {
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
    std::size_t const length = length_of_name(pattern);
    std::optional<std::string_view> const value = find(pattern.substr(0, length));
    internal_check(value && (!braced || pattern.substr(length).starts_with('}')));
    text += *value;
    pattern.remove_prefix(length + (braced ? 1 : 0));
  }
}

// The first place of the pattern, with its dollar, that is not a known name; empty if all are known.
std::string_view unknown_place(std::string_view pattern, std::set<std::string, std::less<>> const &known);

// A reusable set of values.
class Filling {
public:
  Filling &set(std::string const &name, std::string value) {
    values_.insert_or_assign(name, std::move(value));
    return *this;
  }
  Filling &set(std::string const &name, std::size_t value) { return set(name, std::to_string(value)); }
  // Sets a_name, AName and A_NAME.
  Filling &set_name(std::string const &name, std::string const &value);
  std::string operator()(std::string_view pattern) const;

private:
  std::map<std::string, std::string, std::less<>> values_;
};

// A pattern parsed once, with the language's words filled in.
class PreparedPattern {
public:
  // `names`: the remaining placeholders.
  PreparedPattern(Language const &language, std::string_view pattern, std::initializer_list<std::string_view> names);

  // `values`: in the order of `names`.
  void append_to(std::string &text, std::initializer_list<std::string_view> values) const;

private:
  // Text, followed by a value.
  struct Piece {
    std::string text;
    std::size_t value;
  };
  static constexpr std::size_t no_value = ~std::size_t{0};

  std::vector<Piece> pieces_;
};

} // namespace symreal
