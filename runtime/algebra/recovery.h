// Structure recovery: textbook code brought below careful code by the algebra of real numbers.
#pragma once

#include "graph/graph.h"

namespace symreal::algebra {

inline constexpr int least_effort = 0, usual_effort = 2, most_effort = 3;

// The graph with fewer operations, or as it is. The same for the same graph and effort.
Graph recover_structure(Graph const &graph, int effort);

} // namespace symreal::algebra
