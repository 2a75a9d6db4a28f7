// Conversion between graphs and networks.
#pragma once

#include "engine/graph/graph.h"
#include "engine/ops/cost_model.h"
#include "engine/optimise/algebra/network.h"

#include <optional>

namespace symreal::algebra {

// Network of a graph. Sums, differences, products, quotients and negations are algebra unless exact; all other
// operations are opaque. The roots are those of the graph, in its order.
Network network_of(Graph const &graph, CostModel const &costs = usual_costs());

// Graph of a network, equivalent to `graph`. Returns nullopt if a constant exceeds the range of a double.
std::optional<Graph> graph_of(Network const &network, Graph const &graph);

} // namespace symreal::algebra
