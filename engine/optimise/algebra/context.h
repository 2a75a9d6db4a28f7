// Context that all networks of one graph share.
#pragma once

#include "engine/ops/cost_model.h"
#include "engine/optimise/algebra/angles.h"
#include "engine/optimise/algebra/hazards.h"

#include <algorithm>
#include <cmath>

namespace symreal::algebra {

struct Context {
  explicit Context(CostModel const &costs = usual_costs()) {
    double const other = (costs[Op::add] + costs[Op::mul]) / 2;
    division = other > 0 ? static_cast<int>(std::lround(std::clamp(costs[Op::div] / other, 1.0, 100.0))) : 1;
  }

  int division; // cost of a quotient; sums and products cost 1
  HazardSets hazards;
  Angles angles;
};

} // namespace symreal::algebra
