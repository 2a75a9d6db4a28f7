// Task graphs for tests, the same ones for the same numbers.
#pragma once

#include "engine/analysis/scheduling/random.h"
#include "engine/analysis/tasks/task_graph.h"

namespace symreal {

struct GraphShape {
  TaskId tasks;
  unsigned percent; // of the pairs that depend on each other
  unsigned longest; // duration; the shortest is 1, or 0 with `instants`
  unsigned kinds = 1;
  bool instants = false;
};

inline TaskGraph random_graph(GraphShape const &shape, Random &random) {
  TaskGraph graph;
  std::vector<TaskId> before;
  for (TaskId task = 0; task < shape.tasks; ++task) {
    before.clear();
    for (TaskId other = 0; other < task; ++other)
      if (random.below(100) < shape.percent) before.push_back(other);
    graph.add(static_cast<Time>(random.below(shape.longest + shape.instants)) + !shape.instants, before);
    if (shape.kinds > 1) graph.kind.push_back(static_cast<std::uint8_t>(random.below(shape.kinds)));
  }
  return graph;
}

// Each task but those of the first layer has one to three predecessors in the layer before its own.
inline TaskGraph layered_graph(TaskId layers, TaskId tasks_each, unsigned longest, Random &random) {
  TaskGraph graph;
  std::vector<TaskId> before;
  for (TaskId layer = 0; layer < layers; ++layer)
    for (TaskId i = 0; i < tasks_each; ++i) {
      before.clear();
      for (std::uint64_t k = 0; layer != 0 && k < 1 + random.below(3); ++k)
        before.push_back((layer - 1) * tasks_each + static_cast<TaskId>(random.below(tasks_each)));
      graph.add(static_cast<Time>(1 + random.below(longest)), before);
    }
  return graph;
}

} // namespace symreal
