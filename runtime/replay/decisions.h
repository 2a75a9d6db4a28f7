// What a graph decides: the conditions of its selects and guards, taken apart where they are joined by `and`, `or` and
// `not`. Verification counts how often each was met and what it gave.
#pragma once

#include "engine/graph/graph.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace symreal {

struct Decision {
  NodeId condition;
  LocationId location = no_location; // of a guard or select that it belongs to
  bool is_guards = false;            // of a guard; else of a select
};

// Each condition once, in the order of the nodes; without those that are constants. Iterative, linear.
std::vector<Decision> decisions_of(Graph const &graph);

// Of a comparison: the number whose sign it asks for, left minus right. Of another condition: its value.
double margin_of(Graph const &graph, NodeId condition, std::span<double const> values);

// How often a decision was met, by what it gave.
struct DecisionCounts {
  std::size_t yes = 0, no = 0;
};

} // namespace symreal
