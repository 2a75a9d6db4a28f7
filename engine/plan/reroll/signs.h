// Elimination of sign factors that differ between iterations.
//
// A sum in one link of a chain may be a difference in the next, and a body that serves both needs a factor of 1 or -1.
// Most factors are avoidable: an iteration can compute a value negated if its readers subtract instead of adding. The
// negated values of each iteration are chosen here, for all steps together, so that few factors remain.
#pragma once

#include "engine/plan/loop_function.h"

namespace symreal::reroll {

// The function with at most as many operations: its results are equal up to the sign of zeros and NaNs. Its memory may
// hold negated values.
LoopFunction with_few_signs(LoopFunction function);

} // namespace symreal::reroll
