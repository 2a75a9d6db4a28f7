#include "engine/analysis/tasks/operation_tasks.h"

namespace symreal {

OperationCosts unit_costs() {
  OperationCosts costs{};
  for (OperationInfo const &row : operations()) costs[static_cast<std::size_t>(row.op)] = row.cost == 0 ? 0 : 1;
  return costs;
}

OperationCosts table_costs() {
  OperationCosts costs{};
  for (OperationInfo const &row : operations()) costs[static_cast<std::size_t>(row.op)] = row.cost;
  return costs;
}

OperationTasks operation_tasks(Graph const &graph, OperationCosts const &costs) {
  std::vector<char> const live = live_nodes(graph);
  std::vector<char> const recomputed = recomputed_nodes(graph);
  bool const split = !graph.precomputed.empty();
  std::vector<TaskId> task_of(graph.nodes.size(), no_node);
  OperationTasks result;
  for (NodeId id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (!live[id] || is_leaf(node.op) || (split && node.attribute != Attribute::variable && !recomputed[id])) continue;
    std::array<TaskId, 3> before;
    std::size_t count = 0;
    for (NodeId operand : node.operand)
      if (operand != no_node && task_of[operand] != no_node) before[count++] = task_of[operand];
    task_of[id] = static_cast<TaskId>(result.tasks.size());
    result.tasks.add(costs[static_cast<std::size_t>(node.op)], std::span(before.data(), count));
    result.node.push_back(id);
  }
  return result;
}

} // namespace symreal
