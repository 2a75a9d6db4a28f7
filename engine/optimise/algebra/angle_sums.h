// Sines and cosines of sums of angles from those of the parts.
#pragma once

#include "engine/ops/cost_model.h"
#include "engine/optimise/algebra/network.h"

namespace symreal::algebra {

// sin(a + b) = sin(a) cos(b) + cos(a) sin(b), and so on, where a and b are angles whose sine and cosine are there or
// cost less; 2 a is a + a. At most 8 angles are added up: each rounds, so that the result is off by 24 units in the
// last place of 1 at most. Where one is not derived, its value in the field is as if it were, so that what the program
// itself derives is found to be equal.
Network with_angle_sums(Network const &network, CostModel const &costs);

// The other way round: what the program adds up of products of sines and cosines, which it needs for little else, as
// the sine or cosine of a sum of two angles, where that costs less.
Network with_calls_of_angle_sums(Network network, CostModel const &costs);

} // namespace symreal::algebra
