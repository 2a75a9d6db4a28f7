// Common reciprocals: one division per denominator, and one multiplication per quotient.
#pragma once

#include "engine/optimise/algebra/network.h"

namespace symreal::algebra {

// Replaces a / d and b / d by a * (1 / d) and b * (1 / d) if that costs less. The hazards stay the same.
Network with_common_reciprocals(Network const &network);

} // namespace symreal::algebra
