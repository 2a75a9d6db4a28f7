// Signs that differ from iteration to iteration.
//
// What is a sum in one link of a chain is a difference in the next, and in a body that serves both it takes a factor of
// 1 or -1. Most of these factors are not needed: where an iteration computes the negative of a value and whoever reads
// it adds in place of subtracting, nothing is lost. Which iterations compute which negatives is chosen here, for all
// steps together, so that few factors remain.
#pragma once

#include "engine/plan/reroll/loop_program.h"

namespace symreal::reroll {

// The function with at most as many operations: its results are the same numbers, a zero's sign and a NaN's aside. Its
// memory may hold negatives.
LoopFunction with_few_signs(LoopFunction function);

} // namespace symreal::reroll
