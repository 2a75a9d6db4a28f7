// When each task can begin at the earliest and must begin at the latest, and what follows from that alone: slack, the
// critical path, how parallel the tasks are. Linear.
#pragma once

#include "engine/analysis/tasks/task_graph.h"

namespace symreal {

struct Levels {
  std::vector<Time> earliest; // start of each task if all begin as soon as those before them have ended
  std::vector<Time> latest;   // start if all begin as late as the span allows
  Time span = 0;              // the length of the longest path
  Time work = 0;              // all durations together

  Time slack(TaskId task) const { return latest[task] - earliest[task]; }
  double parallelism() const { return span == 0 ? 0 : static_cast<double>(work) / static_cast<double>(span); }
};
Levels levels(TaskGraph const &graph);

// A longest path from its first task to its last; of several the one with the oldest tasks, seen from the end.
std::vector<TaskId> critical_path(TaskGraph const &graph, Levels const &levels);

// How many tasks are under way in each unit of time from 0 to `length`. Tasks that last no time are in none.
using LevelProfile = std::vector<std::uint32_t>;
LevelProfile profile(TaskGraph const &graph, std::vector<Time> const &start, Time length);
std::uint32_t peak(LevelProfile const &profile);

} // namespace symreal
