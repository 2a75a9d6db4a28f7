// Schedules with communication: a task that needs a result of another unit begins later, so each task has a unit from
// the start.
#pragma once

#include "engine/analysis/scheduling/scheduler.h"

namespace symreal {

// List scheduling by the longest path, communication included, places each task in the gap of the unit on which it ends
// first (H. Topcuoglu, S. Hariri, M.-Y. Wu, 2002); then local search varies the order of the tasks and their units;
// small graphs also get branch and bound.
Solution schedule_communicating(TaskGraph const &graph, Units const &units, Effort const &effort);

} // namespace symreal
