#include "engine/emit/language/words.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace symreal {

constexpr static std::size_t most_places = 6;

std::string portable_place(Place place) {
  std::filesystem::path const file = place.file;
  if (file.is_absolute()) place.file = file.filename().string();
  return to_string(place);
}

// Length in bytes of the UTF-8 character at the beginning; 0 if the text does not begin with a valid one.
static std::size_t length_of_character(std::string_view text) {
  auto const byte = [&](std::size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U; };
  unsigned const first = byte(0);
  if (first < 0x80) return 1;
  std::size_t const length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(k) & 0xC0) != 0x80) return 0;
  unsigned const second = byte(1);
  bool const is_overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  bool const is_beyond = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
  return is_overlong || is_beyond ? 0 : length;
}

// U+0000 to U+001F and U+007F to U+009F, U+2028 to U+202E, U+2066 to U+2069.
static bool is_control(std::string_view character) {
  auto const is_within = [&](std::string_view first, std::string_view last) {
    return character.size() == first.size() && first <= character && character <= last;
  };
  return static_cast<unsigned char>(character[0]) < ' ' || character[0] == 0x7F || is_within("\xC2\x80", "\xC2\x9F") ||
         is_within("\xE2\x80\xA8", "\xE2\x80\xAE") || is_within("\xE2\x81\xA6", "\xE2\x81\xA9");
}

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    std::size_t const length = length_of_character(text);
    std::string_view const character = text.substr(0, std::max<std::size_t>(length, 1));
    result += length == 0 ? "?" : is_control(character) ? " " : character;
    text.remove_prefix(character.size());
  }
  return result;
}

std::string in_comment(std::string const &text) {
  std::string result;
  for (char const c : printable(text)) {
    if (!result.empty() && ((result.back() == '*' && c == '/') || (result.back() == '/' && c == '*'))) result += ' ';
    result += c;
  }
  return result;
}

std::string guard_text(Graph const &graph, Guard const &guard) {
  if (guard.location == no_location || graph.locations[guard.location].places.empty()) return guard.text;
  std::vector<Place> const &known = graph.locations[guard.location].places;
  std::string further;
  for (std::size_t i = 1; i < known.size() && i < most_places; ++i)
    further += (i == 1 ? "" : ", ") + portable_place(known[i]);
  if (known.size() > most_places) further += ", ...";
  return portable_place(known.front()) + ": " + guard.text + (further.empty() ? "" : ", in " + further);
}

std::string prefixed(EmitOptions const &options, std::string const &name) {
  return options.prefix.empty() ? name : options.prefix + "_" + name;
}

} // namespace symreal
