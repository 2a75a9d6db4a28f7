// From lines of generated code back to the source lines that they come from.
//
// While a function is printed each statement ends in a marker with the locations of its operations. At the end the
// markers become comments, or go, and leave the map.
#pragma once

#include "emit/print/emitted.h"

#include <string>
#include <vector>

namespace symreal {

// " /*@3,7*/" for the nodes whose operations a statement holds; empty where none has a location.
std::string trace_marker(Graph const &graph, std::vector<NodeId> const &nodes);

// "arm.cpp:12, LLT.h:300 in arm.cpp:40": each location once, files without their directories.
std::string describe_locations(Graph const &graph, std::vector<LocationId> const &locations);

// Replaces the markers of a file.
std::vector<LineOrigin> resolve_markers(std::string &text, Graph const &graph, bool comments);

} // namespace symreal
