#include "engine/analysis/tasks/task_graph.h"

#include <algorithm>

namespace symreal {

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

} // namespace symreal
