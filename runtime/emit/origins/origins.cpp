#include "emit/origins/origins.h"

#include <algorithm>
#include <charconv>

namespace symreal {

std::string trace_marker(Graph const &graph, std::vector<NodeId> const &nodes) {
  if (graph.node_location.empty()) return {};
  std::vector<LocationId> locations;
  for (NodeId id : nodes)
    if (LocationId location = graph.node_location[id]; location != no_location) locations.push_back(location);
  std::sort(locations.begin(), locations.end());
  locations.erase(std::unique(locations.begin(), locations.end()), locations.end());
  std::string list;
  for (LocationId location : locations) list += (list.empty() ? "" : ",") + std::to_string(location);
  return list.empty() ? "" : " /*@" + list + "*/";
}

static std::string in_words(Location const &location) {
  std::string text;
  // The frames further in come first: that is where the operation stands.
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
  // A file's name is the user's: it must not end the comment.
  for (std::size_t end; (end = list.find("*/")) != std::string::npos;) list.replace(end, 2, "* ");
  return list;
}

std::vector<LineOrigin> resolve_markers(std::string &text, Graph const &graph, bool comments) {
  std::vector<LineOrigin> origins;
  std::string result;
  std::size_t first_line = 1, line = 1; // of the statement that is being read
  for (std::size_t at = 0; at < text.size();) {
    std::size_t const end = std::min(text.find('\n', at), text.size());
    std::string_view rest(text.data() + at, end - at);
    std::size_t const marker = rest.find("/*@");
    result.append(rest.substr(0, marker));
    if (marker != rest.npos) {
      std::vector<LocationId> locations;
      char const *digit = rest.data() + marker + 3;
      for (bool more = true; more;) {
        LocationId location = 0;
        digit = std::from_chars(digit, rest.data() + rest.size(), location).ptr;
        locations.push_back(location);
        more = *digit++ == ',';
      }
      while (result.ends_with(' ')) result.pop_back();
      if (comments) result += " /* " + describe_locations(graph, locations) + " */";
      origins.push_back({first_line, line, std::move(locations)});
    }
    bool const only_marker = marker != rest.npos && !comments && result.ends_with('\n');
    if (only_marker) {
      origins.back().last_line = --line;
      result.pop_back();
    }
    result += '\n';
    if (marker != rest.npos || rest.ends_with(';') || rest.ends_with('{') || rest.ends_with('}')) first_line = line + 1;
    ++line;
    at = end + 1;
  }
  text = std::move(result);
  return origins;
}

} // namespace symreal
