// From lines of generated code back to the source lines that they come from.
#pragma once

#include "engine/graph/graph.h"

#include <string>
#include <vector>

namespace symreal {

// The locations of these nodes' operations, each once, in ascending order.
std::vector<LocationId> locations_of(Graph const &graph, std::vector<NodeId> const &nodes);

// "arm.cpp:12, LLT.h:300 in arm.cpp:40": each location once, files without their directories.
std::string describe_locations(Graph const &graph, std::vector<LocationId> const &locations);

} // namespace symreal
