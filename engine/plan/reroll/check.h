// Proof that the steps compute what their function does.
//
// Method: value numbering over every iteration of every step. Two values have one number if they are the same operation
// on operands with the same numbers; besides, only identities that are exact in floating point count: sums and products
// commute, x - y is x + (-y), and signs move through products and quotients, and through sums where zeros have no sign.
// At the end each stored element must hold the value that the graph gives.
#pragma once

#include "engine/plan/loop_function.h"
#include "engine/plan/reroll/sequence.h"

namespace symreal::reroll {

// Description of the first difference; empty if the steps are correct.
std::string find_difference(Sequence const &sequence, LoopFunction const &function, std::vector<NodeId> const &stored,
                            std::vector<NodeId> const &checked, bool zeros_have_signs = true);

} // namespace symreal::reroll
