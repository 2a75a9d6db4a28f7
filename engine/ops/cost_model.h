// Cost model of operations, which selects the cheaper of two ways to compute a value.
#pragma once

#include "engine/ops/operation.h"

namespace symreal {

// Costs in additions; leaves are free.
struct CostModel {
  using Costs = std::array<double, static_cast<std::size_t>(Op::count)>;

  Costs work{};    // throughput cost: each of many independent operations
  Costs latency{}; // from the operands to the result
  double load = 1; // work of reading a number that preprocess stored

  double operator[](Op op) const { return work[static_cast<std::size_t>(op)]; }
  double latency_of(Op op) const { return latency[static_cast<std::size_t>(op)]; }
};

// Costs from column `cost` of the operation table; a load costs as much as an addition.
CostModel const &usual_costs();

} // namespace symreal
