// Where a recorded graph goes: to the driver's directory, or, in a program that was started by hand, through the whole
// pipeline to C.
#pragma once

#include "graph/graph.h"

namespace symreal::trace {

void deliver(Graph const &graph, std::string const &output_file);

} // namespace symreal::trace
