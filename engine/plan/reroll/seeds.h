// Short windows of a sequence that stand there again with the same operands.
#pragma once

#include "engine/plan/reroll/repeats.h"

namespace symreal::reroll {

// Where each of them begins; windows overlap with none of their own kind, one operand at least is no constant, and the
// most frequent ones come first. Time is that of sorting the sequence.
std::vector<std::vector<std::uint32_t>> seeds(Sequence const &sequence);

} // namespace symreal::reroll
