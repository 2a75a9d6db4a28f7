// --snap: replaces constants of a recorded graph by nearby exact ones, and reports it.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/graph.h"
#include "engine/optimise/passes/pass.h"

namespace symreal::tool {

// The graph with exact constants, each reported. Samples check it: throws snap_changes_output if an output changes by
// more than the tolerance.
Graph with_exact_constants(Graph const &recorded, double distance, double tolerance, Report const &report);

// Reports the operations that exact constants would save in mode fast, by rules alone, if any.
void tell_of_exact_constants(Graph const &recorded, PassSettings const &settings, Report const &report);

} // namespace symreal::tool
