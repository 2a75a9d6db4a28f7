// Trimming of repeats: removes iterations that cannot be part of a loop.
#pragma once

#include "engine/plan/reroll/repeats.h"

namespace symreal::reroll {

// Trims aligned repeats. An operand of an iteration must be computed before that iteration, or by the same operation of
// its body in every iteration. The iterations from the first violation on, or those up to it, are left out.
std::vector<Repeat> trimmed(Sequence const &sequence, std::vector<Repeat> const &repeats);

} // namespace symreal::reroll
