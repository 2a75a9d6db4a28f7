// Exact scheduling with communication by branch and bound. A branch is a task and its unit, in order of begin. Unused
// units are interchangeable; of states that differ only in unit names or time, the search follows the earliest.
#pragma once

#include "engine/analysis/scheduling/network.h"
#include "engine/analysis/scheduling/timetable.h"

namespace symreal {

struct ExactTimetable {
  Timetable timetable; // empty if no timetable is shorter than `below`
  bool is_complete;    // the search ended within its node limit
};

// As search_exactly, for at most 64 tasks.
ExactTimetable search_communicating(Network const &network, Units const &units, std::vector<char> const &is_dummy,
                                    std::vector<Time> const &tail, Time below, Time enough, std::uint64_t most_nodes);

} // namespace symreal
