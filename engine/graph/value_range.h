// Value ranges: interval analysis of a graph.
//
// Rounding to nearest is monotone, so the bounds of a sum are the rounded sums of the bounds, and they are attained
// exactly: bounds need no widening.
#pragma once

#include "engine/graph/graph.h"
#include "engine/ops/floating_point.h"

#include <vector>

namespace symreal {

// A closed interval, with or without NaN.
struct Interval {
  double low, high;
  bool nan; // whether the value may be NaN

  bool empty() const { return !(low <= high) && !nan; }
  bool within(Interval const &other) const {
    return (!(low <= high) || (low >= other.low && high <= other.high)) && (!nan || other.nan);
  }
};

class ValueRanges {
public:
  // Linear time. `inputs`: interval per input slot; slots beyond it are unbounded.
  ValueRanges(Graph const &graph, FloatingPoint mode, std::vector<Interval> inputs = {});

  // Range of the node, refined by narrowed ranges of itself and of near operands.
  Interval range(NodeId id) const { return near(id, 4); }
  // Narrows a node's range, as implied by a guard for the rest of the program.
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
  Interval any_; // range of an unknown value: finite in modes other than strict, by premise
  std::vector<Interval> ranges_;
};

} // namespace symreal
