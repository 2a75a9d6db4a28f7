// Groups that the picture of a graph collapses: nodes by source line, lines by function.
#pragma once

#include "engine/graph/graph.h"
#include "tool/html/sources.h"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace symreal::tool {

class Groups {
public:
  Groups(Graph const &graph, Sources const &sources) : graph_(graph), sources_(sources) {}

  // Group of a node, created on first use. Without a place: inputs, parameters, or the operation's name.
  std::size_t of(NodeId node);
  // [{"label": "dynamics.cpp:40", "parent": 3, "file": 0, "line": 40}, ...]; the parent is a function's group.
  nlohmann::ordered_json const &data() const { return data_; }

private:
  std::size_t place_group(LocationId location);
  std::size_t group(std::string const &label, std::size_t parent, std::size_t file, unsigned line);

  Graph const &graph_;
  Sources const &sources_;
  std::map<LocationId, std::size_t> by_location_;
  std::map<std::tuple<std::size_t, std::string, std::size_t, unsigned>, std::size_t> numbers_;
  nlohmann::ordered_json data_ = nlohmann::ordered_json::array();
};

} // namespace symreal::tool
