// Levels: earliest and latest start of each task, and what follows from them: slack, the critical path, parallelism.
// Linear time.
#pragma once

#include "engine/analysis/tasks/task_graph.h"

namespace symreal {

struct Levels {
  std::vector<Time> earliest; // start of each task if all begin as soon as possible
  std::vector<Time> latest;   // start if all begin as late as the span allows
  Time span = 0;              // length of the longest path
  Time work = 0;              // total duration

  Time slack(TaskId task) const { return latest[task] - earliest[task]; }
  double parallelism() const { return span == 0 ? 0 : static_cast<double>(work) / static_cast<double>(span); }
};
Levels levels(TaskGraph const &graph);

// A longest path, first task first; on ties the one with the oldest tasks, compared from the end.
std::vector<TaskId> critical_path(TaskGraph const &graph, Levels const &levels);

// Number of running tasks in each unit of time from 0 to `length`. Tasks of zero duration do not count.
using LevelProfile = std::vector<std::uint32_t>;
LevelProfile profile(TaskGraph const &graph, std::vector<Time> const &start, Time length);
std::uint32_t peak(LevelProfile const &profile);

} // namespace symreal
