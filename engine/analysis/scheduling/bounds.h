// Lower bounds on the length of a timetable.
#pragma once

#include "engine/analysis/scheduling/windows.h"

namespace symreal {

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
