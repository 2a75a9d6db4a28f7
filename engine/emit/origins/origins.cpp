#include "engine/emit/origins/origins.h"

#include <algorithm>

namespace symreal {

std::vector<LocationId> locations_of(Graph const &graph, std::vector<NodeId> const &nodes) {
  std::vector<LocationId> locations;
  if (graph.node_location.empty()) return locations;
  for (NodeId id : nodes)
    if (LocationId location = graph.node_location[id]; location != no_location) locations.push_back(location);
  std::sort(locations.begin(), locations.end());
  locations.erase(std::unique(locations.begin(), locations.end()), locations.end());
  return locations;
}

static std::string in_words(Location const &location) {
  std::string text;
  // The innermost frames come first: they contain the operation.
  for (std::size_t i = location.places.size(); i-- > 0;) {
    Place const &place = location.places[i];
    std::string const name = place.file.substr(place.file.rfind('/') + 1) + ":" + std::to_string(place.line);
    if (i + 1 == location.places.size() || name != text.substr(text.rfind(' ') + 1))
      text += (text.empty() ? "" : " in ") + name;
  }
  return text;
}

std::string describe_locations(Graph const &graph, std::vector<LocationId> const &locations) {
  std::vector<std::string> words;
  for (LocationId location : locations)
    if (std::string text = in_words(graph.locations[location]);
        !text.empty() && std::find(words.begin(), words.end(), text) == words.end())
      words.push_back(std::move(text));
  std::string list;
  for (std::string const &word : words) list += (list.empty() ? "" : ", ") + word;
  // A file name is the user's text: it must not end the comment.
  for (std::size_t end; (end = list.find("*/")) != std::string::npos;) list.replace(end, 2, "* ");
  return list;
}

} // namespace symreal
