// What becomes of a decision on a symbolic value, and under which conditions the program's statements are executed.
#pragma once

#include "engine/ops/floating_point.h"

#include <symreal/decisions.h>

namespace symreal::trace {

// $SYMREAL_FP: under mode finite every value is finite, which settles some conditions.
FloatingPoint floating_point();

// The condition under which statements are executed now: 1, or the conjunction of what with_path pushed.
RealNumber current_path();
// The same of an arm that a process of its own executes (join.h).
void set_arm(RealNumber condition);
RealNumber current_arm();

} // namespace symreal::trace
