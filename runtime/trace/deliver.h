// Where a recorded graph goes.
#pragma once

#include "engine/graph/graph.h"

namespace symreal::trace {

// To the driver's directory; in a program that was started by hand, to generate_here.
void deliver(Graph const &graph, std::string const &output_file);

// The whole pipeline to C, in this process. libsymreal_generate.a has it; libsymreal_runtime.a, which the tool links
// into what it has rewritten, has no emitter and says so (by_hand/).
void generate_here(Graph const &graph, std::string const &output_file);

} // namespace symreal::trace
