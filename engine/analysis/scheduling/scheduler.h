// Scheduler: a short timetable of a task graph, and a lower bound on its length.
//
//   tasks ──parts──▶ a chain of graphs ──windows, bounds──▶ lists ──justified──▶ local search ──▶ exact search
//
// A part is finished as soon as its timetable is as short as a bound. Graphs with communication stay whole
// (communicating.h).
#pragma once

#include "engine/analysis/scheduling/bounds.h"
#include "engine/analysis/scheduling/timetable.h"

#include <cstddef>
#include <cstdint>

namespace symreal {

// Larger graphs get a single list schedule.
inline constexpr std::size_t most_searched_tasks = 20'000;
inline constexpr unsigned most_effort = 3;

// Search effort, counted in steps rather than seconds, so that results are equal on all machines.
struct Effort {
  unsigned level = 1; // 0: lists only; 1: about a second; 2, 3: ten times as much each
  std::uint64_t seed = 1;

  // Number of timetables that the local search tries; `cost` is that of placing a task.
  std::size_t search_steps(std::size_t tasks, std::size_t cost = 1) const;
  // Node limit of the exact search, 0 for no search. It suffices for up to 30 tasks.
  std::uint64_t exact_nodes(std::size_t tasks) const;
};

struct Solution {
  Timetable timetable;
  Time length = 0;
  Bounds bounds;     // bounds before the exact search
  Time at_least = 0; // best lower bound, including that of the exact search
  bool is_optimal() const { return length == at_least; }
};

// `units` has a unit of each kind that a task needs.
Solution schedule_tasks(TaskGraph const &graph, Units const &units, Effort const &effort);

} // namespace symreal
