// Policy for decisions on symbolic values, and the condition under which the program's statements execute.
#pragma once

#include "engine/ops/floating_point.h"

#include <symreal/decisions.h>

namespace symreal::trace {

// Entry `fp` of the request: under mode finite every value is finite, which settles some conditions.
FloatingPoint floating_point();

// The condition under which statements execute now: 1, or the conjunction of those pushed by with_path.
RealNumber current_path();
// The condition of the arm that this process executes (join.h).
void set_arm(RealNumber condition);
RealNumber current_arm();

} // namespace symreal::trace
