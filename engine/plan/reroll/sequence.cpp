#include "engine/plan/reroll/sequence.h"

#include "engine/plan/schedule/order.h"

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
  std::vector<char> const needed = needed_operations(plan, in_compute, roots);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    if (!needed[id]) continue;
    result.position[id] = static_cast<std::uint32_t>(result.operations.size());
    result.operations.push_back(operation_of(graph.nodes[id], static_cast<NodeId>(id)));
  }
  return result;
}

} // namespace symreal::reroll
