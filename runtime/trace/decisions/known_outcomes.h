// What the outcomes of earlier decisions on a path say of a later one.
//
// Two numbers stand in one of four relations: less, equal, greater, or unordered where one is NaN. A comparison asks
// for some of them, and its outcome leaves some. A relation also follows along a chain, a < b and b <= c, in which the
// constants have their order.
#pragma once

#include "engine/graph/node_table.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace symreal::trace {

class KnownOutcomes {
public:
  // Without NaN, !(x < y) says that x >= y.
  explicit KnownOutcomes(bool with_nan = true) : with_nan_(with_nan) {}

  // Of a condition that no path which has come here can answer otherwise.
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
  std::map<Pair, Relations> left_; // the smaller id first
  std::vector<NodeId> constants_;  // in these
};

} // namespace symreal::trace
