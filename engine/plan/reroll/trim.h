// Repeats without the iterations that no loop can have.
#pragma once

#include "engine/plan/reroll/repeats.h"

namespace symreal::reroll {

// Of repeats that are aligned. What an iteration reads must be computed before it begins, or by the same operation of
// its body in every iteration. The iterations from the first that does not fit on, or those up to it, are left out.
std::vector<Repeat> trimmed(Sequence const &sequence, std::vector<Repeat> const &repeats);

} // namespace symreal::reroll
