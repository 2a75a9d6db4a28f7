// Loops that compilers may carry out several iterations of at the same time, and round as before.
//
// gcc's vectoriser fuses a product with the sum behind it, whatever the flags, where it finds sums and differences in
// turn in what stands side by side in memory (its pattern addsub). That takes stores of one iteration to neighbouring
// elements, so a loop without such stores is safe: its vectors are of iterations, which all do the same. Small loops
// that are inside of another one are unrolled before, and then stores of several iterations are one of the outer
// loop's.
#pragma once

#include "engine/plan/reroll/loop_program.h"

namespace symreal::reroll {

// Whether no iteration waits for another one, and no stores of one iteration may be neighbours.
bool is_side_by_side(Step const &step);

} // namespace symreal::reroll
