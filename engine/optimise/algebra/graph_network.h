// From a graph to a network and back.
#pragma once

#include "engine/graph/graph.h"
#include "engine/ops/cost_model.h"
#include "engine/optimise/algebra/network.h"

#include <optional>

namespace symreal::algebra {

// Sums, differences, products, quotients and changes of sign are algebra, but for operations that are exact, which stay
// as they are written. All else is opaque. The roots are those of the graph, in its order.
Network network_of(Graph const &graph, CostModel const &costs = usual_costs());

// The graph that computes what `graph` did, as the network does. Nothing where a number in it is beyond those of
// doubles.
std::optional<Graph> graph_of(Network const &network, Graph const &graph);

} // namespace symreal::algebra
