// What no schedule can beat: the shortest length on some units, and the fewest units for some length.
//
// Method: the work that as-late-as-possible starts put before a time must be done by then, and the work that
// as-soon-as-possible starts put after a time cannot be done before it. Each prefix and each suffix of the levels is
// a bound; the whole, which is both, is the well-known max(span, work / units). This is the bound of Fernandez and
// Bussell over these intervals alone: over all of them it is quadratic. For a length there is one more: what has so
// little slack that it must be under way at a time needs a unit each.
#pragma once

#include "engine/analysis/levels/levels.h"

namespace symreal {

// Refers to what it is made of, and not to the profiles.
class LevelBounds {
public:
  LevelBounds(TaskGraph const &graph, Levels const &levels, LevelProfile const &from_inputs,
              LevelProfile const &from_outputs);

  // max(span, work / units), rounded up.
  Time simple_length(std::uint32_t units) const;
  // At least that.
  Time length(std::uint32_t units) const;
  // For a length of at least the span.
  std::uint32_t units(Time length) const;

private:
  std::uint32_t surely_at_once(Time length) const;

  TaskGraph const &graph_;
  Levels const &levels_;
  Time span_, work_;
  std::vector<Time> due_;  // by time t: what must be done before t
  std::vector<Time> open_; // by time t before the end: what cannot begin earlier
};

} // namespace symreal
