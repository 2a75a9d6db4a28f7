// Decisions of a graph: the conditions of its selects and guards, split at `and`, `or` and `not`. Verification counts
// how often each was met with which outcome.
#pragma once

#include "engine/graph/graph.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace symreal {

struct Decision {
  NodeId condition;
  LocationId location = no_location; // of the guard or select
  bool is_guards = false;            // of a guard; else of a select
};

// Each condition once, in node order, without constants. Iterative, linear.
std::vector<Decision> decisions_of(Graph const &graph);

// Margin of a condition: for a comparison, left minus right, whose sign decides it; for another condition, its value.
double margin_of(Graph const &graph, NodeId condition, std::span<double const> values);

// Number of times that a decision was met, by outcome.
struct DecisionCounts {
  std::size_t yes = 0, no = 0;
};

} // namespace symreal
