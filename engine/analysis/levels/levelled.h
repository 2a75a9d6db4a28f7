// A schedule whose profile is level: peaks are moved into valleys, and no task begins before those that it needs have
// ended.
//
// Method: list scheduling. Whenever a unit is free, it takes of the tasks that are ready the one with the longest way
// to the end. For a bound on the length the fewest units are sought with which that comes to an end in time, from the
// number on that no schedule can go below.
#pragma once

#include "engine/analysis/levels/level_bounds.h"

namespace symreal {

struct Levelled {
  std::vector<Time> start; // per task
  Time length = 0;
  std::uint32_t peak = 0;
};

// At most so many tasks, at least 1, at a time.
Levelled level_for_units(TaskGraph const &graph, Levels const &levels, std::uint32_t units);

// Each task begins between its earliest start and its latest one for this length, which is at least the span. The peak
// is at most that of either profile.
Levelled level_for_length(TaskGraph const &graph, Levels const &levels, LevelBounds const &bounds, Time length);

} // namespace symreal
