// Structure recovery: textbook code brought below careful code by the algebra of real numbers.
#pragma once

#include "graph/graph.h"
#include "ops/cost_model.h"

namespace symreal::algebra {

inline constexpr int least_effort = 0, usual_effort = 2, most_effort = 3;

// The graph with less to compute by these costs, or as it is. The same for the same graph, effort and costs.
Graph recover_structure(Graph const &graph, int effort, CostModel const &costs = usual_costs());

} // namespace symreal::algebra
