// Derivatives of implicit solutions: for x with r(x, p) = 0 they are -(dr/dx)^-1 dr/dp, where r is the residual that
// the program computes from x.
#pragma once

#include "engine/graph/implicit.h"
#include "engine/optimise/differentiate/expressions.h"

#include <functional>
#include <map>
#include <vector>

namespace symreal {

// A system, and the nodes of its residual that depend on the unknowns, in topological order.
struct ImplicitCone {
  ImplicitSystem system;
  std::vector<NodeId> nodes;

  bool has(NodeId id) const;
  bool is_unknown(NodeId id) const;
};
ImplicitCone cone_of(Graph const &graph, NodeId call);

// Tangent of a node from the tangents of its operands; no_node for zero. Recurses only into the residual of a solution.
// Throws not_differentiable if the residual does not determine the solution.
using TangentOf = std::function<NodeId(NodeId)>;
NodeId tangent_along(Graph const &graph, Expressions &expressions, NodeId id, TangentOf const &tangent);

// Adjoints of the results of each implicit call that the reverse sweep has yet to reach.
using SolutionAdjoints = std::map<NodeId, std::vector<NodeId>>;
using AddAdjoint = std::function<void(NodeId operand, NodeId adjoint)>;
// Propagates the adjoint of a node to its operands. Adjoints of solutions wait in `solutions` until the sweep reaches
// their call.
void hand_down(Graph const &graph, Expressions &expressions, NodeId id, NodeId adjoint, SolutionAdjoints &solutions,
               AddAdjoint const &add);

} // namespace symreal
