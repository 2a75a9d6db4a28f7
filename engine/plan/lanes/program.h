// From the vectors that were found to a function: where each vector comes from, and in which order.
#pragma once

#include "engine/plan/lanes/search.h"

namespace symreal::lanes {

LaneFunction lane_function(Function const &function, Found const &found);

} // namespace symreal::lanes
