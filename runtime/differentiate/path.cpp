#include "differentiate/path.h"

#include "differentiate/calls.h"
#include "differentiate/rules.h"

#include <algorithm>

namespace symreal {

namespace {

// Per node, whether it depends on the inputs in one of the ways that `is_way(op, i)` allows.
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
  for (std::size_t id = needed.size(); id-- > 0;) {
    Node const &node = graph.nodes[id];
    if (!needed[id] || is_leaf(node.op)) continue;
    std::vector<NodeId> const arguments = differentiable_arguments(graph, static_cast<NodeId>(id));
    for (NodeId const argument : arguments)
      if (reached[argument]) needed[argument] = 1;
    if (!arguments.empty()) continue;
    bool jumps = false, is_unknown = false;
    for (std::size_t i = 0; i < arity(node.op); ++i) {
      if (!reached[node.operand[i]]) continue;
      Slope const slope = slope_of(node.op, i);
      if (slope == Slope::formula) needed[node.operand[i]] = 1;
      jumps |= slope == Slope::steps || (slope == Slope::formula && jumps_between(node.op));
      is_unknown |= slope == Slope::unknown;
    }
    if (jumps) path.jumps.push_back(static_cast<NodeId>(id));
    if (is_unknown) path.unknown.push_back(static_cast<NodeId>(id));
  }
  for (std::size_t id = 0; id < needed.size(); ++id) path.carries[id] &= needed[id];
  std::ranges::reverse(path.jumps);
  std::ranges::reverse(path.unknown);
  return path;
}

} // namespace symreal
