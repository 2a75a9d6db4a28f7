// Proof that the lanes of vectors hold the values of the function.
//
// Method: value numbering (schedule/numbering.h) of the function in its order. Each lane must have the number of the
// node that it represents, and each result must be stored.
#pragma once

#include "engine/plan/lanes/scalar_function.h"

namespace symreal::lanes {

// Description of the first difference; empty if the vectors are correct.
std::string find_difference(ScalarFunction const &function, LaneFunction const &lanes);

} // namespace symreal::lanes
