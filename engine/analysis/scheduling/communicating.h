// Timetables with communication: a task that needs a result of another unit begins later, so each task has a unit from
// the beginning.
#pragma once

#include "engine/analysis/scheduling/scheduler.h"

namespace symreal {

// List scheduling by the longest path, communication included, where each task goes to the gap of the unit in which it
// ends first (H. Topcuoglu, S. Hariri, M.-Y. Wu, 2002), then local search on the order of the tasks and on their units;
// for small graphs branch and bound.
Solution schedule_communicating(TaskGraph const &graph, Units const &units, Effort const &effort);

} // namespace symreal
