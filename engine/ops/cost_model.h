// What operations cost beside one another: decides which of two ways to compute a number is the cheaper one.
#pragma once

#include "engine/ops/operation.h"

namespace symreal {

// Leaves are free.
struct CostModel {
  using Costs = std::array<double, static_cast<std::size_t>(Op::count)>;

  Costs work{};    // what each of many operations costs that need not wait for one another
  Costs latency{}; // from the operands to the result
  double load = 1; // work of reading a number that function `preprocess` has stored

  double operator[](Op op) const { return work[static_cast<std::size_t>(op)]; }
  double latency_of(Op op) const { return latency[static_cast<std::size_t>(op)]; }
};

// Column `cost` of the table of operations, in additions; a load costs as much as an addition.
CostModel const &usual_costs();

} // namespace symreal
