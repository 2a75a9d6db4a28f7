// Policy for decisions on symbolic values, and the condition under which the program's statements execute.
#pragma once

#include "engine/ops/floating_point.h"

#include <symreal/decisions.h>

namespace symreal::trace {

// Entry `fp` of the request: under mode finite every value is finite, which settles some conditions.
FloatingPoint floating_point();

// The conditions under which the statements of a thread execute.
struct Conditions {
  static constexpr int as_the_program = -1;
  int policy = as_the_program; // for decisions, of the innermost scope
  RealNumber path = 1.0;       // 1, or the conjunction of those pushed by with_path
  RealNumber arm = 1.0;        // of the arm that this process executes (join.h)
};

} // namespace symreal::trace
