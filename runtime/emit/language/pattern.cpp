#include "emit/language/pattern.h"

#include "diagnostics/diagnostic.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace symreal {

std::string fill(std::string_view pattern, std::span<std::pair<std::string_view, std::string_view> const> values) {
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
    auto const is_letter = [](unsigned char c) { return std::isalpha(c) || c == '_'; };
    auto const length = static_cast<std::size_t>(std::ranges::find_if_not(pattern, is_letter) - pattern.begin());
    std::string_view const name = pattern.substr(0, length);
    auto const value = std::ranges::find(values, name, [](auto const &pair) { return pair.first; });
    internal_check(value != values.end() && (!braced || pattern.substr(length).starts_with('}')));
    text += value->second;
    pattern.remove_prefix(length + (braced ? 1 : 0));
  }
}

static std::string capital(std::string const &text, bool joins) {
  std::string result;
  bool begins = true;
  for (char const c : text) {
    if (joins && c == '_') {
      begins = true;
      continue;
    }
    if (result.empty() && !std::isalpha(static_cast<unsigned char>(c))) result += 'X';
    result += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = false;
  }
  return result;
}

Filling &Filling::set_name(std::string const &name, std::string const &value, bool joins) {
  auto const upper = [](std::string text) {
    for (char &c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
  };
  return set(name, value).set(capital(name, true), capital(value, joins)).set(upper(name), upper(value));
}

std::string Filling::operator()(std::string_view pattern) const {
  std::vector<std::pair<std::string_view, std::string_view>> values(values_.begin(), values_.end());
  return fill(pattern, values);
}

} // namespace symreal
