// Stages of chains that are alike, each or every second or third one: as rows, so many of them in each.
#pragma once

#include "engine/plan/reroll/chains.h"

namespace symreal::reroll {

struct Rows {
  std::size_t first, period; // the first stage, and how many a row has
  Nest nest;                 // turn by turn the chains that have all of them

  std::size_t end() const { return first + period * nest.turns; }
};

// `depths`: where stages begin, in operations before the ends of chains, the longest first; at last 0. None where there
// are too few, or chains do not join them evenly. Time is that of comparing the longest chain with itself a few times.
std::optional<Rows> find_rows(Sequence const &sequence, Chains const &chains, std::vector<std::uint32_t> const &depths);

} // namespace symreal::reroll
