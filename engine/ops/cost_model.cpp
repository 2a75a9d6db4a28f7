#include "engine/ops/cost_model.h"

namespace symreal {

CostModel const &usual_costs() {
  static CostModel const model = [] {
    CostModel made;
    for (OperationInfo const &row : operations()) made.work[static_cast<std::size_t>(row.op)] = row.cost;
    made.latency = made.work;
    return made;
  }();
  return model;
}

} // namespace symreal
