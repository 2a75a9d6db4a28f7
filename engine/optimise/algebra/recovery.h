// Structure recovery: textbook code brought below careful code by the algebra of real numbers.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/graph.h"
#include "engine/ops/cost_model.h"

namespace symreal::algebra {

inline constexpr int least_effort = 0, usual_effort = 2, most_effort = 3;

// What the graph's operations cost; what is free counts nothing.
double cost_of(Graph const &graph, CostModel const &costs);

// The graph with less to compute by these costs, or as it is. The same for the same graph, effort and costs. `tell`
// hears what a graph is too large for (graph_not_searched). Without `searches` only the first step is done: equal
// expressions become one, common denominators one division. It treats equal windows of the graph alike.
Graph recover_structure(Graph const &graph, int effort, CostModel const &costs = usual_costs(), Report const &tell = {},
                        bool searches = true);

} // namespace symreal::algebra
