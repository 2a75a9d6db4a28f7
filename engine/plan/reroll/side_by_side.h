// Vectorisation safety: loops that compilers may vectorise without changing results.
//
// gcc's vectoriser, in its pattern addsub, fuses a product with the sum behind it, whatever the flags, if sums and
// differences alternate in neighbouring elements of memory. That takes stores of one iteration to neighbouring
// elements, so a loop without such stores is safe: its vectors hold one operation of several iterations. Small inner
// loops are unrolled first, and then the stores of several inner iterations belong to one outer iteration.
#pragma once

#include "engine/plan/reroll/loop_program.h"

namespace symreal::reroll {

// Whether iterations are independent, and no two stores of one iteration can be neighbours.
bool is_side_by_side(Step const &step);

} // namespace symreal::reroll
