// What all networks that are made of one graph have in common.
#pragma once

#include "algebra/angles.h"
#include "algebra/hazards.h"

namespace symreal::algebra {

struct Context {
  HazardSets hazards;
  Angles angles;
};

} // namespace symreal::algebra
