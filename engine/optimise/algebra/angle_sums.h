// Angle-sum identities: sines and cosines of sums of angles from those of the parts.
#pragma once

#include "engine/ops/operation.h"
#include "engine/optimise/algebra/network.h"

namespace symreal::algebra {

// A linear combination of atoms in quarters, ordered by atom: q + p / 2 is {q: 4, p: 2}.
using AngleForm = std::vector<std::pair<Index, int>>;

// Angle form: the argument of a sine or cosine as a linear combination, which shows the related ones.
AngleForm form_of(Network const &network, Index angle);

// Angle of live sines and cosines that depend on an input, with those functions; one per form.
struct Angle {
  AngleForm form;
  Index node, sine = no_index, cosine = no_index;
};
std::vector<Angle> angles_of(Network const &network);

// Applies sin(a + b) = sin(a) cos(b) + cos(a) sin(b) and its like if the sines and cosines of a and b exist or cost
// less; 2 a is a + a. Sums at most 8 angles: each rounds, so the result is off by at most 24 units in the last place of
// 1. Angles that stay calls get the field values of the identity too, so that derivations in the program are found to
// be equal.
Network with_angle_sums(Network const &network, CostModel const &costs);

// The inverse: replaces sums of products of sines and cosines that have few other uses by the sine or cosine of a sum
// of two angles if that costs less.
Network with_calls_of_angle_sums(Network network, CostModel const &costs);

} // namespace symreal::algebra
