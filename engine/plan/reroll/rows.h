// Rows: periodic stages of chains, grouped so that each row has one period of them.
#pragma once

#include "engine/plan/reroll/chains.h"

namespace symreal::reroll {

struct Rows {
  std::size_t first, period; // the first stage, and the number of stages per row
  Nest nest;                 // turn by turn the chains that have all stages of the row

  std::size_t end() const { return first + period * nest.turns; }
};

// `depths`: begins of stages, in operations before the ends of chains, descending to 0. Returns nullopt if rows are too
// few, or if chains do not join them evenly. Takes the time of comparing the longest chain with itself a few times.
std::optional<Rows> find_rows(Sequence const &sequence, Chains const &chains, std::vector<std::uint32_t> const &depths);

} // namespace symreal::reroll
