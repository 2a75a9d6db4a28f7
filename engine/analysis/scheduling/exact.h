// Exact scheduling without communication by branch and bound.
//
// A branch decides, at a time when a task has ended, which ready tasks begin. A branch is pruned if
// - the interval bound from each time on shows that it cannot beat the best timetable;
// - a task that was ready and had a unit would begin later although that unit is idle until then: it could begin
// earlier;
// - a longer task would follow a shorter one on its unit, was ready when that began, and all successors of the shorter
//   one are its successors too: they could change places;
// - a task would begin before another of the same duration and kind that all its successors wait for as well;
// - the same tasks were running, done and held back at an earlier or the same time, with equal remaining times.
//
// Pruning preserves one shortest timetable: the one with the least sum of start * duration^2, and among these the one
// in which tasks with more successors, then those of smaller id, begin earlier. Each rule leads to a smaller one.
#pragma once

#include "engine/analysis/scheduling/bounds.h"

namespace symreal {

constexpr std::size_t most_exact_tasks = 64;

struct ExactResult {
  std::vector<Time> start; // empty if no timetable is shorter than `below`
  bool is_complete;        // the search ended within its node limit
  std::uint64_t nodes;
};

// The shortest timetable below `below`, or one of length `enough`; after `most_nodes` nodes the shortest found. The
// network has at most 64 tasks and is not reversed.
ExactResult search_exactly(Network const &network, Units const &units, Windows const &windows, Time below, Time enough,
                           std::uint64_t most_nodes);

} // namespace symreal
