// Schedules with communication: a task that needs a result of another unit begins later, so each task has a unit from
// the start.
#pragma once

#include "engine/analysis/scheduling/scheduler.h"

namespace symreal {

// List scheduling by the longest path, communication included, places each task in the gap of the unit on which it ends
// first (H. Topcuoglu, S. Hariri, M.-Y. Wu, 2002); then local search varies the order of the tasks and their units;
// small graphs also get branch and bound.
Solution schedule_communicating(TaskGraph const &graph, Units const &units, Effort const &effort);

// Exact scheduling with communication by branch and bound. A branch is a task and its unit, in order of begin. Unused
// units are interchangeable; of states that differ only in unit names or time, the search follows the earliest.
struct ExactTimetable {
  Timetable timetable; // empty if no timetable is shorter than `below`
  bool is_complete;    // the search ended within its node limit
};

// As search_exactly, for at most 64 tasks.
ExactTimetable search_communicating(Network const &network, Units const &units, std::vector<char> const &is_dummy,
                                    std::vector<Time> const &tail, Time below, Time enough, std::uint64_t most_nodes);

} // namespace symreal
