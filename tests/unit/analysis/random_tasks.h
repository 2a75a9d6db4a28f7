// Random task graphs of every shape: chains, layers, tasks that last no time.
#pragma once

#include "engine/analysis/tasks/task_graph.h"

#include <random>

namespace symreal {

inline TaskGraph random_tasks(unsigned seed) {
  std::mt19937 random(seed);
  auto const below = [&](unsigned end) { return static_cast<unsigned>(random() % end); };
  TaskGraph graph;
  unsigned const count = 1 + below(60), reach = 1 + below(20), longest = 1 + below(4);
  for (TaskId task = 0; task < count; ++task) {
    std::vector<TaskId> before;
    for (unsigned k = below(4); k > 0 && task > 0; --k) before.push_back(task - 1 - below(std::min(task, reach)));
    graph.add(below(longest + 1), before);
  }
  return graph;
}

constexpr unsigned random_graphs = 300;

} // namespace symreal
