#include "tool/report/source_lines.h"

#include <algorithm>
#include <fmt/ostream.h>
#include <map>
#include <nlohmann/json.hpp>

namespace symreal::tool {
namespace {

using Line = std::pair<std::string, unsigned>;

// Counts the operations among `nodes` that `counts` says, by line.
template <class Counts, class Add> void count(Graph const &graph, Counts const &counts, Add const &add) {
  for (std::size_t id = 0; id < graph.node_location.size(); ++id) {
    LocationId location = graph.node_location[id];
    if (location == no_location || is_leaf(graph.nodes[id].op) || !counts(id)) continue;
    if (std::vector<Place> const &places = graph.locations[location].places; !places.empty())
      add(Line(places.front().file, places.front().line));
  }
}

} // namespace

std::vector<LineCount> operations_by_line(Graph const &recorded, Graph const &optimised) {
  std::map<Line, LineCount> lines;
  count(recorded, [](std::size_t) { return true; }, [&](Line const &line) { ++lines[line].recorded; });
  std::vector<char> const live = live_nodes(optimised);
  count(optimised, [&](std::size_t id) { return live[id]; }, [&](Line const &line) { ++lines[line].generated; });
  std::vector<LineCount> result;
  for (auto &[line, counts] : lines)
    result.push_back({{line.first, line.second, 0}, counts.recorded, counts.generated});
  std::stable_sort(result.begin(), result.end(),
                   [](LineCount const &a, LineCount const &b) { return a.generated > b.generated; });
  return result;
}

void print_lines(std::ostream &out, std::vector<LineCount> const &lines) {
  if (lines.empty()) return;
  constexpr std::size_t most = 20;
  fmt::print(out, "  operations by source line (recorded, generated)\n");
  std::size_t recorded = 0, generated = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (i < most)
      fmt::print(out, "    {:>12}{:>12}  {}:{}\n", lines[i].recorded, lines[i].generated, lines[i].place.file,
                 lines[i].place.line);
    else
      recorded += lines[i].recorded, generated += lines[i].generated;
  if (lines.size() > most)
    fmt::print(out, "    {:>12}{:>12}  on {} further lines\n", recorded, generated, lines.size() - most);
}

nlohmann::ordered_json to_json(std::vector<LineCount> const &lines) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (LineCount const &line : lines)
    json.push_back({{"file", line.place.file},
                    {"line", line.place.line},
                    {"recorded", line.recorded},
                    {"generated", line.generated}});
  return json;
}

} // namespace symreal::tool
