// Division by a common denominator: one division, and a multiplication for each quotient.
#pragma once

#include "engine/optimise/algebra/network.h"

namespace symreal::algebra {

// a / d and b / d as a * (1 / d) and b * (1 / d), where that costs less. What divides did so before.
Network with_common_reciprocals(Network const &network);

} // namespace symreal::algebra
