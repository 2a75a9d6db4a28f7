#include "tool/report/source_lines.h"

#include "engine/graph/statistics.h"

#include <algorithm>
#include <fmt/ostream.h>
#include <map>
#include <nlohmann/json.hpp>

namespace symreal::tool {
std::vector<LineCount> operations_by_line(RecordedCounts const &recorded, Graph const &optimised) {
  std::map<std::pair<std::string, unsigned>, LineCount> lines;
  std::vector<std::size_t> const generated = operations_by_location(optimised, true);
  for (std::size_t location = 0; location < optimised.locations.size(); ++location) {
    std::vector<Place> const &places = optimised.locations[location].places;
    std::size_t const before = recorded.by_location[location];
    if (places.empty() || (before == 0 && generated[location] == 0)) continue;
    LineCount &line = lines[{places.front().file, places.front().line}];
    line.recorded += before;
    line.generated += generated[location];
  }
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
