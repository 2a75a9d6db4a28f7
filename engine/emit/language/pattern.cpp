#include "engine/emit/language/pattern.h"

#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace symreal {

std::string fill(std::string_view pattern, std::span<std::pair<std::string_view, std::string_view> const> values) {
  return fill_places(pattern, [&](std::string_view name) { return find_place(values, name); });
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
