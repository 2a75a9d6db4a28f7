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

Premises check_premises(Graph const &graph, std::span<double const> values) {
  Premises premises;
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (!std::isfinite(values[id])) premises.finite = false;
    if (is_leaf(node.op) || !info(node.op).has(flag::ZERO_SIGN)) continue;
    for (NodeId operand : node.operand)
      if (operand != no_node && values[operand] == 0) premises.zero_sign_unseen = false;
  }
  return premises;
}

} // namespace symreal
