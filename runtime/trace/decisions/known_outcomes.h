// Outcomes of conditions that need no decision: implied by a path's earlier outcomes, settled by the bounds of the
// numbers in the condition, or assumed, since a computed number is seldom exactly zero.
#pragma once

#include "engine/graph/graph.h"
#include "engine/graph/node_table.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace symreal::trace {

// Implications of a path's earlier outcomes for later conditions.
//
// Two numbers stand in one of four relations: less, equal, greater, or unordered if one is NaN. A comparison asks for
// some of them, and its outcome leaves some. Relations are transitive, as in a < b and b <= c, and constants have their
// natural order.
class KnownOutcomes {
public:
  // !(x < y) implies x >= y only without NaN.
  explicit KnownOutcomes(bool with_nan = true) : with_nan_(with_nan) {}

  // The outcome of a condition that earlier outcomes imply; nullopt if both are possible.
  std::optional<bool> outcome(NodeTable const &nodes, NodeId condition) const;
  void add(NodeTable const &nodes, NodeId condition, bool outcome);

private:
  using Relations = unsigned; // a set
  using Pair = std::pair<NodeId, NodeId>;
  enum class Order { unknown, at_most, less };

  Relations relations(NodeTable const &nodes, Pair pair) const;
  Order order(NodeTable const &nodes, NodeId from, NodeId to) const;

  bool with_nan_;
  std::map<NodeId, bool> outcomes_;
  std::map<Pair, Relations> left_; // keyed with the smaller id first
  std::vector<NodeId> constants_;  // in these
};

// The outcome that the bounds of the numbers imply: by the operations alone, as of `fabs(x) < -1`, and by the ranges of
// these inputs, as of `x > 4`.
std::optional<bool> outcome_of_bounds(NodeTable const &nodes, NodeId condition);
std::optional<bool> outcome_in_ranges(NodeTable const &nodes, NodeId condition, std::vector<Object> const &inputs);

// The outcome of a test of a computed number for exact zero, as in `pivot != 0` and `norm <= DBL_MIN`, if the number is
// not 0; nullopt for other conditions. Plain inputs and parameters do not count: a mode that is 0 may well
// be meant.
std::optional<bool> outcome_without_zero(NodeTable const &nodes, NodeId condition);

} // namespace symreal::trace
