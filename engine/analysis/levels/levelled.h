// Levelled schedules: schedules with a flat profile that respects all dependencies.
//
// Method: list scheduling. A free unit takes the ready task with the longest path to the end. For a bound on the
// length, a search from the lower bound on units upwards finds the fewest units with which list scheduling ends in
// time.
#pragma once

#include "engine/analysis/levels/levels.h"

namespace symreal {

struct Levelled {
  std::vector<Time> start; // per task
  Time length = 0;
  std::uint32_t peak = 0;
};

// At most `units` tasks run at a time; `units` is at least 1.
Levelled level_for_units(TaskGraph const &graph, Levels const &levels, std::uint32_t units);

// Each task begins between its earliest and its latest start for this length, which is at least the span. The peak is
// at most that of either profile.
Levelled level_for_length(TaskGraph const &graph, Levels const &levels, LevelBounds const &bounds, Time length);

} // namespace symreal
