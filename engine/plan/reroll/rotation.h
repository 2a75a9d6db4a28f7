// Loop rotation: the choice of the operation at which a loop's period begins.
#pragma once

#include "engine/plan/reroll/repeats.h"

namespace symreal::reroll {

// Loop over operations begin..end-1, each of which matches the one a period later, rotated so that the fewest values
// are loop-carried. A body that splits a source iteration in the middle would carry its intermediate values, and passes
// could not simplify it (bodies.h).
Repeat rotated(Sequence const &sequence, std::uint32_t begin, std::uint32_t end, std::uint32_t period);

} // namespace symreal::reroll
