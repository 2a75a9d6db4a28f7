// Seeds: short windows of a sequence that recur with the same operands.
#pragma once

#include "engine/plan/reroll/repeats.h"

namespace symreal::reroll {

// Positions of each seed, the most frequent seed first. Occurrences of one seed do not overlap, and at least one
// operand of a seed is not constant. Takes the time of sorting the sequence.
std::vector<std::vector<std::uint32_t>> seeds(Sequence const &sequence);

} // namespace symreal::reroll
