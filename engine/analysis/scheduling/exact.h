// The shortest timetable without communication, by branch and bound.
//
// A branch decides, at a time when something has ended, which ready tasks begin. Branches are left out where
// - no end of it can be shorter than the best timetable: intervals from each time on are looked at, as for the bounds;
// - a task that was ready and had a unit would begin later with that unit idle until then: it could begin earlier;
// - a longer task would follow a shorter one on its unit, was ready when that began, and all that waits for the shorter
//   one waits for it as well: they could change places;
// - a task would begin before another of the same duration and kind that all its successors wait for as well;
// - the same tasks were running, done and held back at an earlier or the same time, counted from which the rest is
// equal.
//
// Of the shortest timetables the one is never left out whose sum of start * duration^2 is least, and among these that
// where tasks with more successors, then those of smaller id, begin earlier: each rule leads to one where this is less.
#pragma once

#include "engine/analysis/scheduling/windows.h"

namespace symreal {

constexpr std::size_t most_exact_tasks = 64;

struct ExactResult {
  std::vector<Time> start; // empty if there is none below `below`
  bool is_complete;        // nothing was left out for want of nodes
  std::uint64_t nodes;
};

// A timetable that is shorter than `below`, as short as possible, or of length `enough`; after `most_nodes` the
// shortest so far. The network has at most 64 tasks and is not reversed.
ExactResult search_exactly(Network const &network, Units const &units, Windows const &windows, Time below, Time enough,
                           std::uint64_t most_nodes);

} // namespace symreal
