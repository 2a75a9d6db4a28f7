// Decisions of a graph, and samples at their boundaries. A decision is a condition of its selects and guards, split at
// `and`, `or` and `not`; verification counts how often each was met with which outcome. Random samples seldom come near
// the point where a comparison changes its answer, and may never reach one side of it; mistakes like < for <= show only
// there.
//
// Method: each decision gets two of the drawn samples with different answers. If all give the same answer, one is
// moved, number by number, to where the line through two values of the margin crosses zero. Between
// the two bisection finds neighbours: the last sample with the one answer and the first with the other.
#pragma once

#include "engine/graph/graph.h"
#include "runtime/replay/samples.h"

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

struct Boundaries {
  std::vector<Sample> samples; // in pairs, one on each side
  std::size_t decisions = 0;   // of the graph
  std::size_t crossed = 0;     // with a boundary found
};

// The result depends on graph and seed only. The work is bounded: large graphs get fewer searches. Empty for a graph
// that calls functions of a program, which cannot be evaluated here. `apart`: distance kept between the two samples, as
// a fraction of their first distance; 0: they are neighbours.
Boundaries find_boundaries(Graph const &graph, std::uint64_t seed, double apart = 0);

} // namespace symreal
