#include "engine/emit/language/pattern.h"

#include "engine/emit/language/language.h"

#include <algorithm>
#include <cctype>

namespace symreal {

std::string_view unknown_place(std::string_view pattern, std::set<std::string, std::less<>> const &known) {
  while (true) {
    pattern.remove_prefix(std::min(pattern.find('$'), pattern.size()));
    if (pattern.empty()) return {};
    if (pattern.starts_with("$$")) {
      pattern.remove_prefix(2);
      continue;
    }
    std::size_t const begin = pattern.starts_with("${") ? 2 : 1;
    std::string_view const name = pattern.substr(begin, length_of_name(pattern.substr(begin)));
    std::size_t const end = begin + name.size();
    if (!known.contains(name) || (begin == 2 && !pattern.substr(end).starts_with('}'))) return pattern.substr(0, end);
    pattern.remove_prefix(end);
  }
}

// A word, or several joined by underscores, as AName.
static std::string capital(std::string const &text) {
  std::string result;
  bool begins = true;
  for (char const c : text) {
    if (c == '_') {
      begins = true;
      continue;
    }
    if (result.empty() && !std::isalpha(static_cast<unsigned char>(c))) result += 'X';
    result += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = false;
  }
  return result;
}

std::array<std::string, 3> in_three_cases(std::string const &name) {
  std::string upper = name;
  for (char &c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return {name, capital(name), upper};
}

Filling &Filling::set_name(std::string const &name, std::string const &value) {
  auto const names = in_three_cases(name), values = in_three_cases(value);
  for (std::size_t k = 0; k < names.size(); ++k) set(names[k], values[k]);
  return *this;
}

std::string Filling::operator()(std::string_view pattern) const {
  return fill_places(pattern, [&](std::string_view name) -> std::optional<std::string_view> {
    auto const found = values_.find(name);
    return found == values_.end() ? std::nullopt : std::optional<std::string_view>(found->second);
  });
}

PreparedPattern::PreparedPattern(Language const &language, std::string_view pattern,
                                 std::initializer_list<std::string_view> names) {
  // Fills the placeholders with characters that patterns never contain, to split the text there.
  constexpr std::string_view marks("\0\1\2\3", 4);
  internal_check(names.size() <= marks.size());
  std::string const text = fill_places(with_words(language, pattern), [&](std::string_view name) {
    auto const place = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    internal_check(place < names.size());
    return std::optional(marks.substr(place, 1));
  });
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t const end = std::min(text.find_first_of(marks, begin), text.size());
    pieces_.push_back({text.substr(begin, end - begin), end == text.size() ? no_value : marks.find(text[end])});
    begin = end + 1;
  }
}

void PreparedPattern::append_to(std::string &text, std::initializer_list<std::string_view> values) const {
  for (Piece const &piece : pieces_) {
    text += piece.text;
    if (piece.value != no_value) text += values.begin()[piece.value];
  }
}

} // namespace symreal
