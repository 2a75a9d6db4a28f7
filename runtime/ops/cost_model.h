// What operations cost beside one another: decides which of two ways to compute a number is the cheaper one.
#pragma once

#include "ops/operation.h"

namespace symreal {

struct CostModel {
  std::array<double, static_cast<std::size_t>(Op::count)> costs{}; // leaves are free
  double load = 1;                                                 // of a number that function `preprocess` has stored

  double operator[](Op op) const { return costs[static_cast<std::size_t>(op)]; }
};

// Column `cost` of the table of operations, in additions.
CostModel const &usual_costs();

} // namespace symreal
