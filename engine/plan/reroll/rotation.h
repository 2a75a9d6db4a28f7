// Where in a period a loop begins.
#pragma once

#include "engine/plan/reroll/repeats.h"

namespace symreal::reroll {

// Of the operations begin..end-1, which match those a period later: the loop that hands the fewest values from an
// iteration to the next. A body that begins in the middle of what its source had as one would carry what stands half
// computed there, and passes could make nothing of it (bodies.h).
Repeat rotated(Sequence const &sequence, std::uint32_t begin, std::uint32_t end, std::uint32_t period);

} // namespace symreal::reroll
