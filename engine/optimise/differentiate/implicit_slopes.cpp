#include "engine/optimise/differentiate/implicit_slopes.h"

#include "engine/graph/opaque.h"
#include "engine/optimise/differentiate/linear_system.h"

#include <algorithm>

namespace symreal {

bool ImplicitCone::has(NodeId id) const { return std::ranges::binary_search(nodes, id); }
bool ImplicitCone::is_unknown(NodeId id) const {
  return std::ranges::find(system.unknowns, id) != system.unknowns.end();
}

ImplicitCone cone_of(Graph const &graph, NodeId call) {
  ImplicitCone cone{system_of(graph, call), {}};
  NodeId const first = std::ranges::min(cone.system.unknowns);
  std::vector<char> depends(call - first, 0), needed(call - first, 0);
  auto const operands = [&](NodeId id) {
    Node const &node = graph.nodes[id];
    return is_leaf(node.op) ? std::span<NodeId const>() : std::span<NodeId const>(node.operand);
  };
  for (NodeId const unknown : cone.system.unknowns) depends[unknown - first] = 1;
  for (NodeId id = first; id < call; ++id)
    for (NodeId const operand : operands(id))
      if (operand != no_node && operand >= first && depends[operand - first]) depends[id - first] = 1;
  for (NodeId const residual : cone.system.residuals)
    if (residual >= first) needed[residual - first] = 1;
  for (NodeId id = call; id-- > first;) {
    if (!needed[id - first] || !depends[id - first] || cone.is_unknown(id)) continue;
    cone.nodes.push_back(id);
    for (NodeId const operand : operands(id))
      if (operand != no_node && operand >= first) needed[operand - first] = 1;
  }
  std::ranges::reverse(cone.nodes);
  return cone;
}

namespace {

// Tangents of the residual along a direction in which the unknowns have the tangents `of_unknown`.
std::vector<NodeId> residual_along(Graph const &graph, Expressions &expressions, ImplicitCone const &cone,
                                   TangentOf const &of_unknown, TangentOf const &of_others) {
  std::map<NodeId, NodeId> own;
  TangentOf const tangent = [&](NodeId id) {
    if (cone.is_unknown(id)) return of_unknown(id);
    auto const found = own.find(id);
    return found != own.end() ? found->second : of_others(id);
  };
  for (NodeId const id : cone.nodes) own[id] = tangent_along(graph, expressions, id, tangent);
  std::vector<NodeId> result;
  for (NodeId const residual : cone.system.residuals) result.push_back(tangent(residual));
  return result;
}

// Jacobian of the residual by the unknowns, row-major.
SquareMatrix jacobian_of(Graph const &graph, Expressions &expressions, ImplicitCone const &cone) {
  std::size_t const count = cone.system.unknowns.size();
  SquareMatrix matrix(count, std::vector<NodeId>(count, no_node));
  NodeId const one = expressions.constant(1);
  for (std::size_t j = 0; j < count; ++j) {
    auto const column = residual_along(
        graph, expressions, cone, [&](NodeId id) { return id == cone.system.unknowns[j] ? one : no_node; },
        [](NodeId) { return no_node; });
    for (std::size_t i = 0; i < count; ++i) matrix[i][j] = column[i];
  }
  return matrix;
}

std::vector<NodeId> solution(Graph const &graph, Expressions &expressions, NodeId call, SquareMatrix matrix,
                             std::vector<NodeId> right) {
  auto found = solve(expressions, std::move(matrix), std::move(right));
  if (!found)
    fail(DiagnosticId::not_differentiable, place_of(graph, system_of(graph, call).unknowns[0]), // where x is computed
         "the residual in implicit(x, r) does not determine x: an element of it depends on none of x, or one of x has "
         "no "
         "influence on it");
  return std::move(*found);
}

} // namespace

NodeId tangent_along(Graph const &graph, Expressions &expressions, NodeId id, TangentOf const &tangent) {
  if (!is_implicit_solution(graph, id)) {
    NodeId sum = no_node;
    expressions.for_each_slope(id, [&](NodeId operand, auto const &partial) {
      if (NodeId const along = tangent(operand); along != no_node)
        sum = expressions.sum(sum, expressions.product(along, partial()));
    });
    return sum;
  }
  NodeId const call = graph.nodes[id].operand[0];
  ImplicitCone const cone = cone_of(graph, call);
  auto right = residual_along(graph, expressions, cone, [](NodeId) { return no_node; }, tangent);
  for (NodeId &one : right) one = expressions.negative(one);
  auto const solved = solution(graph, expressions, call, jacobian_of(graph, expressions, cone), std::move(right));
  return solved[result_of(graph, graph.nodes[id])];
}

// Propagates the adjoints of a call's results: solves for weights of the residual, then sweeps its cone in reverse.
static void hand_down_solution(Graph const &graph, Expressions &expressions, NodeId call,
                               std::vector<NodeId> const &adjoints, AddAdjoint const &add) {
  ImplicitCone const cone = cone_of(graph, call);
  std::vector<NodeId> right;
  for (NodeId const one : adjoints) right.push_back(expressions.negative(one));
  auto const weights =
      solution(graph, expressions, call, transposed(jacobian_of(graph, expressions, cone)), std::move(right));
  std::map<NodeId, NodeId> own;
  SolutionAdjoints inner;
  AddAdjoint const add_own = [&](NodeId operand, NodeId one) {
    if (cone.is_unknown(operand)) return;
    if (!cone.has(operand)) return add(operand, one);
    auto const [sum, is_new] = own.try_emplace(operand, one);
    if (!is_new) sum->second = expressions.sum(sum->second, one);
  };
  for (std::size_t i = 0; i < weights.size(); ++i) add_own(cone.system.residuals[i], weights[i]);
  for (auto node = cone.nodes.rbegin(); node != cone.nodes.rend(); ++node) {
    auto const found = own.find(*node);
    hand_down(graph, expressions, *node, found == own.end() ? no_node : found->second, inner, add_own);
  }
}

void hand_down(Graph const &graph, Expressions &expressions, NodeId id, NodeId adjoint, SolutionAdjoints &solutions,
               AddAdjoint const &add) {
  if (auto const found = solutions.find(id); found != solutions.end())
    return hand_down_solution(graph, expressions, id, found->second, add);
  if (adjoint == no_node) return;
  if (is_implicit_solution(graph, id)) {
    Node const &node = graph.nodes[id];
    std::vector<NodeId> &all = solutions[node.operand[0]];
    all.resize(system_of(graph, node.operand[0]).unknowns.size(), no_node);
    all[result_of(graph, node)] = adjoint;
    return;
  }
  expressions.for_each_slope(
      id, [&](NodeId operand, auto const &partial) { add(operand, expressions.product(adjoint, partial())); });
}

} // namespace symreal
