// Mapping of generated lines to the source lines that they come from.
#pragma once

#include "engine/graph/graph.h"

#include <string>
#include <vector>

namespace symreal {

// Locations of these operations, each once, in ascending order.
std::vector<LocationId> locations_of(Graph const &graph, std::vector<NodeId> const &nodes);

// Text such as "arm.cpp:12, LLT.h:300 in arm.cpp:40": each location once, file names without directories.
std::string describe_locations(Graph const &graph, std::vector<LocationId> const &locations);

} // namespace symreal
