// The shortest timetable with communication, by branch and bound. A branch is a task and its unit, in the order in
// which the tasks begin. Of units without work one is as good as another; of states that differ in the names of units,
// or in time alone, the earliest is followed.
#pragma once

#include "engine/analysis/scheduling/network.h"
#include "engine/analysis/scheduling/timetable.h"

namespace symreal {

struct ExactTimetable {
  Timetable timetable; // empty if there is none below `below`
  bool is_complete;    // nothing was left out for want of nodes
};

// As search_exactly. At most 64 tasks.
ExactTimetable search_communicating(Network const &network, Units const &units, std::vector<char> const &is_dummy,
                                    std::vector<Time> const &tail, Time below, Time enough, std::uint64_t most_nodes);

} // namespace symreal
