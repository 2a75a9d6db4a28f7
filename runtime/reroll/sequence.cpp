#include "reroll/sequence.h"

namespace symreal::reroll {

static Operation operation_of(Node const &node, NodeId id) {
  Operation result{id, node.op == Op::sub ? Op::add : node.op};
  for (NodeId operand : node.operand)
    if (operand != no_node) result.operands[result.count++] = {operand, false};
  result.operands[1].negated = node.op == Op::sub;
  result.may_exchange = result.op == Op::add || node.op == Op::mul;
  return result;
}

Sequence sequence(Schedule const &plan, bool in_compute, std::vector<NodeId> const &roots) {
  Graph const &graph = *plan.graph;
  std::vector<std::uint32_t> const none(graph.nodes.size(), no_slot);
  Sequence result{&graph,
                  {},
                  std::vector<std::uint32_t>(graph.nodes.size(), no_position),
                  in_compute ? plan.constant_slot : none,
                  in_compute && !plan.angles.element.empty() ? plan.angles.element : none};
  std::vector<char> needed(graph.nodes.size(), 0);
  for (NodeId root : roots) needed[root] = 1;
  auto const is_read = [&](std::size_t id) {
    return is_leaf(graph.nodes[id].op) || result.slot[id] != no_slot || result.angle[id] != no_slot;
  };
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    if (!needed[id] || is_read(id)) continue;
    for (NodeId operand : graph.nodes[id].operand)
      if (operand != no_node) needed[operand] = 1;
  }
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    if (!needed[id] || is_read(id)) continue;
    result.position[id] = static_cast<std::uint32_t>(result.operations.size());
    result.operations.push_back(operation_of(graph.nodes[id], static_cast<NodeId>(id)));
  }
  return result;
}

} // namespace symreal::reroll
