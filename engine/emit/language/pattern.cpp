#include "engine/emit/language/pattern.h"

#include "engine/emit/language/language.h"

#include <algorithm>
#include <cctype>

namespace symreal {

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

Filling &Filling::set_name(std::string const &name, std::string const &value) {
  auto const upper = [](std::string text) {
    for (char &c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
  };
  return set(name, value).set(capital(name), capital(value)).set(upper(name), upper(value));
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
