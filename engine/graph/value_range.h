// Bounds of the values of nodes, as far as the operations tell.
//
// Rounding to nearest never changes the order of two numbers, so the bounds of a sum are the rounded sums of the
// bounds, and they are met exactly: no bound needs to be widened.
#pragma once

#include "engine/graph/graph.h"
#include "engine/ops/floating_point.h"

#include <vector>

namespace symreal {

// Numbers between two bounds, which belong to it.
struct Interval {
  double low, high;
  bool nan; // or a NaN

  bool empty() const { return !(low <= high) && !nan; }
  bool within(Interval const &other) const {
    return (!(low <= high) || (low >= other.low && high <= other.high)) && (!nan || other.nan);
  }
};

class ValueRanges {
public:
  // Linear in the nodes. `inputs`: between which bounds each lies, by slot; those behind them may be anything.
  ValueRanges(Graph const &graph, FloatingPoint mode, std::vector<Interval> inputs = {});

  // With what was learnt of the node itself, and of its operands, as far as these are near.
  Interval range(NodeId id) const { return near(id, 4); }
  // From a condition that holds from now on.
  void narrow(NodeId id, Interval const &range) { ranges_[id] = range; }

private:
  struct Bound;
  Interval near(NodeId id, int depth) const;
  Interval of(Node const &node, int depth) const;
  Interval operand(Node const &node, unsigned k, int depth) const { return near(node.operand[k], depth - 1); }
  Interval bounded(Interval const &range) const;
  Interval monotone(Node const &node, int depth) const;
  Interval corners(Node const &node, int depth) const;
  Interval cut_off(Node const &node, double low, double high, int depth) const;
  Interval integer(Node const &node, double low, double high, int depth) const;
  Interval extreme(Node const &node, int depth) const;
  Interval rest(Interval const &x, Interval const &y) const;
  Interval choice(Node const &node, Bound const &outer, int depth) const;
  Interval arm(Node const &node, unsigned k, Bound const &outer, int depth) const;
  Bound bound_of(NodeId condition, bool holds, bool is_left) const;

  Graph const &graph_;
  std::vector<Interval> const inputs_;
  Interval any_; // whatever a value may be: in modes other than strict it is finite by their premise
  std::vector<Interval> ranges_;
};

} // namespace symreal
