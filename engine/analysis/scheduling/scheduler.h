// From a task graph to a short timetable, and how short one can be at best.
//
//   tasks ──parts──▶ a chain of graphs ──windows, bounds──▶ lists ──justified──▶ local search ──▶ exact search
//
// Each step ends the work on a part whose timetable is as short as a bound. With communication there are no parts
// (communicating.h).
#pragma once

#include "engine/analysis/scheduling/bounds.h"
#include "engine/analysis/scheduling/effort.h"
#include "engine/analysis/scheduling/timetable.h"

namespace symreal {

struct Solution {
  Timetable timetable;
  Time length = 0;
  Bounds bounds;     // what is cheap to know
  Time at_least = 0; // the best bound, that of an exact search included: no timetable is shorter
  bool is_optimal() const { return length == at_least; }
};

// There is a unit of each kind that a task has.
Solution schedule_tasks(TaskGraph const &graph, Units const &units, Effort const &effort);

} // namespace symreal
