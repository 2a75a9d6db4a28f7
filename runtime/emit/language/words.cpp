#include "emit/language/words.h"

#include <filesystem>
#include <fmt/format.h>

namespace symreal {

constexpr static std::size_t most_places = 6;

std::string portable_place(Place place) {
  std::filesystem::path const file = place.file;
  if (file.is_absolute()) place.file = file.filename().string();
  return to_string(place);
}

std::string in_comment(std::string const &text) {
  std::string result;
  for (char c : text) {
    if (c == '\n') c = ' ';
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
