#include "engine/optimise/differentiate/path.h"

#include "engine/optimise/differentiate/calls.h"
#include "engine/optimise/differentiate/implicit_slopes.h"
#include "engine/optimise/differentiate/rules.h"

#include <algorithm>

namespace symreal {

namespace {

// Per node, whether it depends on `inputs` through operands that `is_way(op, i)` allows.
template <class IsWay>
std::vector<char> dependent(Graph const &graph, std::span<std::uint32_t const> inputs, IsWay const &is_way) {
  std::vector<char> slots(graph.input_count(), 0);
  for (std::uint32_t const slot : inputs) slots[slot] = 1;
  std::vector<char> result(graph.nodes.size(), 0);
  for (std::size_t id = 0; id < result.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (node.op == Op::input) result[id] = slots[node.slot()];
    if (is_leaf(node.op)) continue;
    for (std::size_t i = 0; i < arity(node.op); ++i)
      if (result[node.operand[i]] && is_way(node.op, i)) result[id] = 1;
    for (NodeId const argument : differentiable_arguments(graph, static_cast<NodeId>(id)))
      if (result[argument]) result[id] = 1;
    if (is_implicit_call(graph, static_cast<NodeId>(id)))
      for (NodeId const residual : system_of(graph, static_cast<NodeId>(id)).residuals)
        if (result[residual]) result[id] = 1;
    if (is_implicit_solution(graph, static_cast<NodeId>(id))) result[id] = result[node.operand[0]];
  }
  return result;
}

} // namespace

DerivativePath find_path(Graph const &graph, std::span<NodeId const> outputs, std::span<std::uint32_t const> inputs) {
  std::vector<char> const reached = dependent(graph, inputs, [](Op, std::size_t) { return true; });
  DerivativePath path{
      dependent(graph, inputs, [](Op op, std::size_t i) { return slope_of(op, i) == Slope::formula; }), {}, {}};
  std::vector<char> needed(graph.nodes.size(), 0);
  for (NodeId const output : outputs) needed[output] = 1;
  // Passes the operands of node `id` on the path to `need`; records jumps and unknown derivatives.
  auto const look_at = [&](NodeId id, auto const &need) {
    Node const &node = graph.nodes[id];
    std::vector<NodeId> const arguments = differentiable_arguments(graph, id);
    for (NodeId const argument : arguments)
      if (reached[argument]) need(argument);
    if (is_implicit_solution(graph, id)) return need(node.operand[0]);
    if (!arguments.empty() || is_leaf(node.op)) return;
    bool jumps = false, is_unknown = false;
    for (std::size_t i = 0; i < arity(node.op); ++i) {
      if (!reached[node.operand[i]]) continue;
      Slope const slope = slope_of(node.op, i);
      if (slope == Slope::formula) need(node.operand[i]);
      jumps |= slope == Slope::steps || (slope == Slope::formula && jumps_between(node.op));
      is_unknown |= slope == Slope::unknown;
    }
    if (jumps) path.jumps.push_back(id);
    if (is_unknown) path.unknown.push_back(id);
  };
  auto const need = [&](NodeId operand) { needed[operand] = 1; };
  for (std::size_t k = needed.size(); k-- > 0;) {
    auto const id = static_cast<NodeId>(k);
    if (!needed[id]) continue;
    if (!is_implicit_call(graph, id)) {
      look_at(id, need);
      continue;
    }
    // The residual determines the derivative of the unknowns, not the algorithm that found them.
    ImplicitCone const cone = cone_of(graph, id);
    for (NodeId const residual : cone.system.residuals)
      if (!cone.has(residual)) need(residual);
    for (NodeId const inner : cone.nodes)
      if (graph.nodes[inner].op != Op::argument &&
          (graph.nodes[inner].op != Op::call || is_implicit_call(graph, inner)))
        look_at(inner, [&](NodeId operand) {
          if (!cone.has(operand) && !cone.is_unknown(operand)) need(operand);
        });
  }
  std::ranges::sort(path.jumps, std::greater());
  std::ranges::sort(path.unknown, std::greater());
  for (std::size_t id = 0; id < needed.size(); ++id) path.carries[id] &= needed[id];
  std::ranges::reverse(path.jumps);
  std::ranges::reverse(path.unknown);
  return path;
}

} // namespace symreal
