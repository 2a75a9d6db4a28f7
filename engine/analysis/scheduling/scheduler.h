// Scheduler: a short timetable of a task graph, and a lower bound on its length.
//
//   tasks ──parts──▶ a chain of graphs ──windows, bounds──▶ lists ──justified──▶ local search ──▶ exact search
//
// A part is finished as soon as its timetable is as short as a bound. Graphs with communication stay whole
// (communicating.h).
#pragma once

#include "engine/analysis/scheduling/bounds.h"
#include "engine/analysis/scheduling/effort.h"
#include "engine/analysis/scheduling/timetable.h"

namespace symreal {

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
