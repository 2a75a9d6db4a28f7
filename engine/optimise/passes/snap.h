// Snapping (--snap): constants that arithmetic left near 0, 1, -1, 1/2 or -1/2 become these numbers.
#pragma once

#include "engine/graph/graph.h"

#include <vector>

namespace symreal {

inline constexpr double usual_snap = 1e-12, largest_snap = 1e-3;

struct SnappedConstant {
  double value, exact;
  std::size_t uses;    // operations and results that used it
  LocationId location; // of the first use that has one
};

struct Snapped {
  Graph graph;
  std::vector<SnappedConstant> constants; // in order of first use
};

// Constants of few digits stay, as their author wrote them; so do operands of exact operations, comparisons and
// functions. A divisor never becomes 0.
Snapped snap_constants(Graph const &graph, double distance);

} // namespace symreal
