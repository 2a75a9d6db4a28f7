// Lower bounds: on the begin and end of each task, and on the length of a timetable.
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

struct Bounds {
  Time critical_path = 0; // length of the longest path
  Time work = 0;          // largest work of a kind divided by its units
  // Interval bound (E. B. Fernandez and B. Bussell, 1973; J. Erschler and P. Lopez, 1990): work of each task that lies
  // within an interval no matter how early or late the task runs.
  Time interval = 0;

  Time best() const;
};

Time critical_path(Network const &network);
Time work_bound(Network const &network, Units const &units);
// Raises the interval bound until all examined intervals have capacity for their work; `effort` is the approximate
// number of steps.
Bounds bounds(Network const &network, Units const &units, Windows const &windows, std::size_t effort = 10'000'000);

} // namespace symreal
