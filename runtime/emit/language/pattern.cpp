#include "emit/language/pattern.h"

#include "diagnostics/diagnostic.h"

#include <algorithm>
#include <cctype>

namespace symreal {

std::string fill(std::string_view pattern,
                 std::initializer_list<std::pair<std::string_view, std::string_view>> values) {
  std::string text;
  while (true) {
    std::size_t const dollar = std::min(pattern.find('$'), pattern.size());
    text += pattern.substr(0, dollar);
    if (dollar == pattern.size()) return text;
    pattern.remove_prefix(dollar + 1);
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

} // namespace symreal
