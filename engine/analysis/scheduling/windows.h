// Windows: bounds on the begin and end of each task.
#pragma once

#include "engine/analysis/scheduling/network.h"
#include "engine/analysis/scheduling/timetable.h"

namespace symreal {

// In every timetable, a task begins at `head` or later, and the timetable lasts for `tail` or longer after the task's
// end.
struct Windows {
  std::vector<Time> head, tail;
};

// Computes windows by longest paths and, for at most 8192 tasks, by the work of all ancestors: those that cannot begin
// before a time share the units from then on.
Windows windows(Network const &network, Units const &units);

} // namespace symreal
