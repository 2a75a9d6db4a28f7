// Numbers that a solver has found, and the residual that is 0 there: for their derivatives the equations count, and not
// what the solver did. In a graph that is a pure function which takes the unknowns and the residual, and gives the
// unknowns.
#pragma once

#include "engine/graph/graph.h"

#include <vector>

namespace symreal {

External implicit_function(std::uint32_t count);
bool is_implicit(External const &external);
// Whether what is called so takes as many unknowns as it takes residuals and gives.
bool is_well_formed_implicit(External const &external);

// Of a call of it.
struct ImplicitSystem {
  std::vector<NodeId> unknowns, residuals;
};
bool is_implicit_call(Graph const &graph, NodeId id);
// Of what it gives, which is a result of the call.
bool is_implicit_solution(Graph const &graph, NodeId id);
ImplicitSystem system_of(Graph const &graph, NodeId call);

// Each solution is what was found, and nothing more.
Graph without_implicit(Graph graph);

} // namespace symreal
