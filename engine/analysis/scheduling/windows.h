// When tasks can begin and end at all.
#pragma once

#include "engine/analysis/scheduling/network.h"
#include "engine/analysis/scheduling/timetable.h"

namespace symreal {

// Of each task, in every timetable: it begins at `head` or later, and the timetable goes on for `tail` or longer after
// its end.
struct Windows {
  std::vector<Time> head, tail;
};

// By longest paths, and, where there are at most 8192 tasks, by the work of all ancestors: those that cannot begin
// before a time must share the units from then on.
Windows windows(Network const &network, Units const &units);

} // namespace symreal
