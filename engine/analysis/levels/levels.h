// Levels: earliest and latest start of each task, and what follows from them: slack, the critical path, parallelism,
// bounds on levelled schedules. Linear time.
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

// Bounds on levelled schedules: the shortest length on some units, and the fewest units for some length.
//
// Method: the work that as-late-as-possible starts place before a time must be done by then, and the work that
// as-soon-as-possible starts place after a time cannot be done before it. Each prefix and each suffix of the levels is
// a bound; the whole, which is both, is the well-known max(span, work / units). This is the bound of Fernandez and
// Bussell restricted to these intervals: over all of them it is quadratic. A length gives one more bound: tasks whose
// slack is so small that they must run at some time need a unit each.
//
// Keeps references to the graph and levels, but not to the profiles.
class LevelBounds {
public:
  LevelBounds(TaskGraph const &graph, Levels const &levels, LevelProfile const &from_inputs,
              LevelProfile const &from_outputs);

  // max(span, work / units), rounded up.
  Time simple_length(std::uint32_t units) const;
  // A tighter bound, at least simple_length.
  Time length(std::uint32_t units) const;
  // Fewest units for `length`, which is at least the span.
  std::uint32_t units(Time length) const;

private:
  std::uint32_t surely_at_once(Time length) const;

  TaskGraph const &graph_;
  Levels const &levels_;
  Time span_, work_;
  std::vector<Time> due_;  // by time t: work that must be done before t
  std::vector<Time> open_; // by time t before the end: work that cannot begin earlier
};

} // namespace symreal
