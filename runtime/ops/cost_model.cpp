#include "ops/cost_model.h"

namespace symreal {

CostModel const &usual_costs() {
  static CostModel const model = [] {
    CostModel made;
    for (OperationInfo const &row : operations()) made.costs[static_cast<std::size_t>(row.op)] = row.cost;
    return made;
  }();
  return model;
}

} // namespace symreal
