// Bin packing of independent tasks on units within a given time. It shows misfits that work bounds miss, as with few
// long tasks on many units.
#pragma once

#include "engine/analysis/scheduling/bounds.h"

namespace symreal {

struct Packing {
  enum class Fits { no, yes, unknown } fits;
  std::vector<unsigned> unit; // per task, if they fit
};

// Whether tasks of these durations, at most 64, fit on units of time `capacity` each. Fills unit by unit, each with the
// longest remaining task and a maximal set of others (S. Martello and P. Toth, 1990).
Packing pack(std::vector<Time> const &duration, unsigned units, Time capacity, std::uint64_t most_nodes);

// Lower bound between `length` and `enough`: tasks with at least some head and some tail must fit in between. For at
// most 64 tasks.
Time packing_bound(Network const &network, Units const &units, Windows const &windows, Time length, Time enough);

// Shortest timetable of independent tasks.
struct IndependentPacking {
  std::vector<Time> start; // empty if no timetable shorter than `below` was found
  Time at_least;           // lower bound on the length
};
IndependentPacking pack_independent(Network const &network, Units const &units, Time at_least, Time below);

} // namespace symreal
