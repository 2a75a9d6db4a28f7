// The proof that steps compute what their function does.
//
// Method: every iteration of every step is carried out with the numbers of values in place of values. Two values have
// one number if they are the same operation of values with the same numbers; only what is exact in floating point is
// known besides: that sums and products commute, x - y is x + (-y), and signs go through products and quotients; where
// zeros have no sign, also through sums. At the end each element that is filled must hold the value that the graph
// says.
#pragma once

#include "engine/plan/reroll/loop_program.h"
#include "engine/plan/reroll/sequence.h"

namespace symreal::reroll {

// What is wrong, in words; empty where nothing is.
std::string find_difference(Sequence const &sequence, LoopFunction const &function, std::vector<NodeId> const &stored,
                            std::vector<NodeId> const &checked, bool zeros_have_signs = true);

} // namespace symreal::reroll
