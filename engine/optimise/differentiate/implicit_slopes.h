// Derivatives of numbers that a solver has found: of x with r(x, p) = 0 they are -(dr/dx)^-1 dr/dp, where r is what the
// program has computed of x.
#pragma once

#include "engine/graph/implicit.h"
#include "engine/optimise/differentiate/expressions.h"

#include <functional>
#include <map>
#include <vector>

namespace symreal {

// A system, and what its residual needs that depends on its unknowns, in the order of the nodes.
struct ImplicitCone {
  ImplicitSystem system;
  std::vector<NodeId> nodes;

  bool has(NodeId id) const;
  bool is_unknown(NodeId id) const;
};
ImplicitCone cone_of(Graph const &graph, NodeId call);

// The derivative of a node along a direction, from those of what it depends on; no_node for zero. Recurses into the
// residual of a solution alone. Throws not_differentiable where that does not determine the solution.
using TangentOf = std::function<NodeId(NodeId)>;
NodeId tangent_along(Graph const &graph, Expressions &expressions, NodeId id, TangentOf const &tangent);

// Of the results of each call of an implicit function that a sweep has passed.
using SolutionAdjoints = std::map<NodeId, std::vector<NodeId>>;
using AddAdjoint = std::function<void(NodeId operand, NodeId adjoint)>;
// Hands the adjoint of a node to what it depends on. Those of solutions wait in `solutions` until the sweep comes to
// their call.
void hand_down(Graph const &graph, Expressions &expressions, NodeId id, NodeId adjoint, SolutionAdjoints &solutions,
               AddAdjoint const &add);

} // namespace symreal
