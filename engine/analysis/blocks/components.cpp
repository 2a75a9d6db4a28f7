#include "engine/analysis/blocks/components.h"

#include <algorithm>
#include <numeric>

namespace symreal {

namespace {

TaskId root(std::vector<TaskId> &parent, TaskId task) {
  while (parent[task] != task) task = parent[task] = parent[parent[task]];
  return task;
}

} // namespace

std::size_t Components::count() const {
  return tasks.size() - static_cast<std::size_t>(std::ranges::count(tasks, std::size_t{0}));
}

std::size_t Components::largest() const { return tasks.empty() ? 0 : *std::ranges::max_element(tasks); }

Components components(TaskGraph const &graph) {
  // The root of a set is its oldest task, which therefore gets its number first.
  std::vector<TaskId> parent(graph.size());
  std::iota(parent.begin(), parent.end(), TaskId{0});
  for (TaskId task = 0; task < graph.size(); ++task)
    for (TaskId before : graph.predecessors(task)) {
      TaskId const a = root(parent, task), b = root(parent, before);
      parent[std::max(a, b)] = std::min(a, b);
    }
  Components result;
  result.of_task.resize(graph.size());
  for (TaskId task = 0; task < graph.size(); ++task) {
    TaskId const oldest = root(parent, task);
    if (oldest == task) {
      result.of_task[task] = static_cast<std::uint32_t>(result.tasks.size());
      result.tasks.push_back(0);
      result.work.push_back(0);
    }
    std::uint32_t const number = result.of_task[task] = result.of_task[oldest];
    result.tasks[number] += graph.duration[task] != 0;
    result.work[number] += graph.duration[task];
  }
  return result;
}

} // namespace symreal
