#include "tool/output/line_map.h"

#include <nlohmann/json.hpp>

namespace symreal::tool {

using Json = nlohmann::ordered_json;

static Json to_json(Location const &location) {
  Json places = Json::array();
  for (Place const &place : location.places)
    places.push_back({{"file", place.file}, {"line", place.line}, {"column", place.column}});
  return places;
}

std::string line_map(EmittedFile const &file, Graph const &graph) {
  Json lines = Json::array();
  for (LineOrigin const &origin : file.origins) {
    Json sources = Json::array();
    for (LocationId location : origin.locations) sources.push_back(to_json(graph.locations[location]));
    lines.push_back({{"first", origin.first_line}, {"last", origin.last_line}, {"sources", std::move(sources)}});
  }
  return Json{{"version", 1}, {"file", file.name}, {"lines", std::move(lines)}}.dump(1) + "\n";
}

} // namespace symreal::tool
