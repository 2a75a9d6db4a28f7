// Below which length no timetable exists.
#pragma once

#include "engine/analysis/scheduling/windows.h"

namespace symreal {

struct Bounds {
  Time critical_path = 0; // the longest path
  Time work = 0;          // the work of a kind, shared evenly by its units
  // Of the work that must be done within an interval (E. B. Fernandez and B. Bussell, 1973; J. Erschler and P. Lopez,
  // 1990): what of each task lies there however early or late it is done.
  Time interval = 0;

  Time best() const;
};

Time critical_path(Network const &network);
Time work_bound(Network const &network, Units const &units);
// The bound of intervals is raised until no interval that is looked at has more work than units; `effort` is how many
// steps that may take, about.
Bounds bounds(Network const &network, Units const &units, Windows const &windows, std::size_t effort = 10'000'000);

} // namespace symreal
