// Tasks that wait for nothing on units, within a given time: bin packing. Where few long tasks share many units, no
// amount of work tells how badly they fit.
#pragma once

#include "engine/analysis/scheduling/windows.h"

namespace symreal {

struct Packing {
  enum class Fits { no, yes, unknown } fits;
  std::vector<unsigned> unit; // per task, if it fits
};

// Whether tasks of these durations, 64 at most, fit on units that have the time `capacity` each. Fills unit by unit,
// each with the longest task that is left and so many others that no further one fits (S. Martello and P. Toth, 1990).
Packing pack(std::vector<Time> const &duration, unsigned units, Time capacity, std::uint64_t most_nodes);

// A bound, at least `length` and at most `enough`: tasks that can begin at a time at the earliest, and after which some
// time must pass, must fit in between. For 64 tasks at most.
Time packing_bound(Network const &network, Units const &units, Windows const &windows, Time length, Time enough);

// The shortest timetable of tasks that wait for nothing.
struct IndependentPacking {
  std::vector<Time> start; // empty if none is found that is shorter than `below`
  Time at_least;           // no timetable is shorter
};
IndependentPacking pack_independent(Network const &network, Units const &units, Time at_least, Time below);

} // namespace symreal
