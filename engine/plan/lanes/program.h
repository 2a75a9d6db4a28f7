// Lane program construction: sources and order of the vectors that the search found.
#pragma once

#include "engine/plan/lanes/search.h"

namespace symreal::lanes {

LaneFunction lane_function(Function const &function, Found const &found);

} // namespace symreal::lanes
