// Delivery of a recorded graph.
#pragma once

#include "engine/graph/graph.h"

namespace symreal::trace {

// Writes the graph to the driver's directory; in a program started by hand, passes it to generate_here.
void deliver(Graph const &graph, std::string const &output_file);

// Runs the whole pipeline to C in this process. Defined in libsymreal_generate.a; libsymreal_runtime.a, which the tool
// links into rewritten programs, has no emitter and reports that (by_hand/).
void generate_here(Graph const &graph, std::string const &output_file);

} // namespace symreal::trace
