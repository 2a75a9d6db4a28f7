#include "graph/evaluate.h"

#include <cmath>

namespace symreal {

std::vector<double> evaluate(Graph const &graph, std::span<double const> inputs, std::span<double const> parameters) {
  std::vector<double> values;
  values.reserve(graph.nodes.size());
  auto operand = [&](NodeId id) { return id == no_node ? 0.0 : values[id]; };
  for (Node const &node : graph.nodes) switch (node.op) {
    case Op::constant: values.push_back(node.value()); break;
    case Op::input: values.push_back(inputs[node.slot()]); break;
    case Op::parameter: values.push_back(parameters[node.slot()]); break;
    default:
      values.push_back(evaluate(node.op, operand(node.operand[0]), operand(node.operand[1]), operand(node.operand[2])));
    }
  return values;
}

std::size_t first_failing_guard(Graph const &graph, std::span<double const> values) {
  for (std::size_t k = 0; k < graph.guards.size(); ++k)
    if (values[graph.guards[k].condition] == 0) return k;
  return graph.guards.size();
}

// Of a node's operands, those that its value is computed from.
static std::array<NodeId, 3> active_operands(Node const &node, std::span<double const> values) {
  std::array<NodeId, 3> operand = node.operand;
  bool const holds = values[operand[0]] != 0;
  if (node.op == Op::select) operand[holds ? 2 : 1] = no_node;
  if (node.op == Op::logical_and && !holds) operand[1] = no_node;
  if (node.op == Op::logical_or && holds) operand[1] = no_node;
  return operand;
}

std::vector<char> active_nodes(Graph const &graph, std::span<double const> values) {
  std::vector<char> active(graph.nodes.size(), 0);
  std::size_t const failing = first_failing_guard(graph, values);
  for (std::size_t k = 0; k < graph.guards.size() && k <= failing; ++k) active[graph.guards[k].condition] = 1;
  if (failing == graph.guards.size())
    for (NodeId result : graph.results) active[result] = 1;
  for (std::size_t id = graph.nodes.size(); id-- > 0;)
    if (active[id] && !is_leaf(graph.nodes[id].op))
      for (NodeId operand : active_operands(graph.nodes[id], values))
        if (operand != no_node) active[operand] = 1;
  return active;
}

Premises check_premises(Graph const &graph, std::span<double const> values) {
  Premises premises;
  std::vector<char> const active = active_nodes(graph, values);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    if (!active[id]) continue;
    Node const &node = graph.nodes[id];
    if (!std::isfinite(values[id])) premises.finite = false;
    if (is_leaf(node.op) || !info(node.op).has(flag::ZERO_SIGN)) continue;
    for (NodeId operand : node.operand)
      if (operand != no_node && values[operand] == 0) premises.zero_sign_unseen = false;
  }
  return premises;
}

} // namespace symreal
