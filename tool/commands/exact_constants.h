// What --snap makes of a recorded graph, and what is said about it.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/graph.h"
#include "engine/optimise/passes/pass.h"

namespace symreal::tool {

// The graph with exact constants, each of which is reported. It is tried on samples: throws snap_changes_output where
// an output changes by more than the tolerance.
Graph with_exact_constants(Graph const &recorded, double distance, double tolerance, Report const &report);

// What that would save in mode fast, by rules alone; nothing is said where it would save nothing.
void tell_of_exact_constants(Graph const &recorded, PassSettings const &settings, Report const &report);

} // namespace symreal::tool
