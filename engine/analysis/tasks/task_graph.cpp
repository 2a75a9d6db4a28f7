#include "engine/analysis/tasks/task_graph.h"

#include <algorithm>

namespace symreal {

TaskId root(std::vector<TaskId> &parent, TaskId task) {
  while (parent[task] != task) task = parent[task] = parent[parent[task]];
  return task;
}

void TaskGraph::add(Time duration_of_task, std::span<TaskId const> before) {
  auto const first = static_cast<std::ptrdiff_t>(predecessor.size());
  predecessor.insert(predecessor.end(), before.begin(), before.end());
  std::sort(predecessor.begin() + first, predecessor.end());
  predecessor.erase(std::unique(predecessor.begin() + first, predecessor.end()), predecessor.end());
  first_predecessor.push_back(static_cast<std::uint32_t>(predecessor.size()));
  duration.push_back(duration_of_task);
}

Successors successors(TaskGraph const &graph) {
  Successors result{std::vector<std::uint32_t>(graph.size() + 1), std::vector<TaskId>(graph.predecessor.size())};
  for (TaskId before : graph.predecessor) ++result.first[before + 1];
  for (std::size_t i = 1; i < result.first.size(); ++i) result.first[i] += result.first[i - 1];
  std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
  for (TaskId task = 0; task < graph.size(); ++task)
    for (TaskId before : graph.predecessors(task)) result.successor[next[before]++] = task;
  return result;
}

Time length(TaskGraph const &graph, std::vector<Time> const &start) {
  Time end = 0;
  for (TaskId task = 0; task < graph.size(); ++task) end = std::max(end, start[task] + graph.duration[task]);
  return end;
}

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
