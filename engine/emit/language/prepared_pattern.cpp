#include "engine/emit/language/prepared_pattern.h"

#include <algorithm>

namespace symreal {

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
