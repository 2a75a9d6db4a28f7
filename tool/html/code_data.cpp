#include "engine/emit/emit.h"
#include "tool/html/data.h"

#include <set>

namespace symreal::tool {

// Distinct source lines of the locations, including inlined ones.
static Json places(Graph const &graph, std::vector<LocationId> const &locations, Sources const &sources) {
  std::set<std::pair<std::size_t, unsigned>> lines;
  for (LocationId location : locations)
    for (Place const &place : graph.locations[location].places)
      if (auto const file = sources.number_of(place.file)) lines.emplace(*file, place.line);
  Json json = Json::array();
  for (auto const &[file, line] : lines) json.push_back({file, line});
  return json;
}

Json code_data(Graph const &graph, FloatingPoint mode, Sources const &sources) {
  constexpr std::size_t most_nodes = 100'000; // a larger page would be slow, and its code unread
  if (graph.nodes.size() > most_nodes) return {{"nodes", graph.nodes.size()}};
  Schedule const plan = schedule(graph);
  EmitOptions options;
  options.base_name = graph.kernel;
  options.mode = mode;
  options.origins = true;
  EmittedFile const file = emit(plan, *find_language("c"), options).front();
  Json origins = Json::array();
  for (LineOrigin const &origin : file.origins)
    origins.push_back({origin.first_line, origin.last_line, places(graph, origin.locations, sources)});
  return {{"name", file.name}, {"text", file.text}, {"origins", std::move(origins)}};
}

} // namespace symreal::tool
