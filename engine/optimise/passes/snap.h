// What --snap does: constants that arithmetic has left near 0, 1, -1, 1/2 or -1/2 become these numbers.
#pragma once

#include "engine/graph/graph.h"

#include <vector>

namespace symreal {

inline constexpr double usual_snap = 1e-12, largest_snap = 1e-3;

struct SnappedConstant {
  double value, exact;
  std::size_t uses;    // operations and results that had it for an operand
  LocationId location; // of the first of them that has one
};

struct Snapped {
  Graph graph;
  std::vector<SnappedConstant> constants; // in the order of their first uses
};

// A number of few digits is as its author wrote it, and stays; so does one that an exact operation, a comparison or a
// function takes, and what divides does not become 0.
Snapped snap_constants(Graph const &graph, double distance);

} // namespace symreal
