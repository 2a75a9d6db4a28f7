// Implicit functions: the solution of equations by a solver, with the residual that is 0 there. Derivatives follow from
// the equations (implicit function theorem) instead of the solver's steps. In a graph this is a pure function that
// takes the unknowns and the residuals and returns the unknowns.
#pragma once

#include "engine/graph/graph.h"

#include <vector>

namespace symreal {

External implicit_function(std::uint32_t count);
bool is_implicit(External const &external);
// Whether the function takes as many unknowns as residuals and returns as many.
bool is_well_formed_implicit(External const &external);

// Unknowns and residuals of a call of an implicit function.
struct ImplicitSystem {
  std::vector<NodeId> unknowns, residuals;
};
bool is_implicit_call(Graph const &graph, NodeId id);
// Whether the node is a result of such a call.
bool is_implicit_solution(Graph const &graph, NodeId id);
ImplicitSystem system_of(Graph const &graph, NodeId call);

// Replaces each solution by the value that the solver found.
Graph without_implicit(Graph graph);

} // namespace symreal
