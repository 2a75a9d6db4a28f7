// Structure recovery: rewrites straightforward code by the algebra of real numbers into fewer operations.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/graph.h"
#include "engine/ops/operation.h"

namespace symreal::algebra {

inline constexpr int least_effort = 0, usual_effort = 2, most_effort = 3;

// Cost of the graph's live operations that depend on inputs.
double cost_of(Graph const &graph, CostModel const &costs);

// The graph with fewer operations by these costs, or unchanged. Deterministic. `tell` receives graph_not_searched if
// the graph is too large. Without `searches` only the first step runs, which merges equal expressions and shares
// divisions; it treats equal windows of the graph alike.
Graph recover_structure(Graph const &graph, int effort, CostModel const &costs = usual_costs(), Report const &tell = {},
                        bool searches = true);

} // namespace symreal::algebra
