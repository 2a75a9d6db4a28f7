// The proof that vectors have what their function computes.
//
// Method: all that the function computes is carried out in its order, with the numbers of values
// (schedule/numbering.h) in place of values. Each lane must have the number of the node that it stands for, and each
// result be stored.
#pragma once

#include "engine/plan/lanes/function.h"

namespace symreal::lanes {

// What is wrong, in words; empty where nothing is.
std::string find_difference(Function const &function, LaneFunction const &lanes);

} // namespace symreal::lanes
