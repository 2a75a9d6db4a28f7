#include "engine/graph/value_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace symreal {

static Interval any_value(FloatingPoint mode) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), largest = std::numeric_limits<double>::max();
  return mode == FloatingPoint::strict ? Interval{-infinity, infinity, true} : Interval{-largest, largest, false};
}

static void meet(Interval &range, Interval const &other) {
  range = {std::max(range.low, other.low), std::min(range.high, other.high), range.nan && other.nan};
}

static Interval magnitude(Interval const &x) {
  return {x.low > 0 ? x.low : (x.high < 0 ? -x.high : 0), std::max(-x.low, x.high), x.nan};
}

// Bound of one node implied by a condition, valid in an arm of a select.
struct ValueRanges::Bound {
  NodeId node = no_node;
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  bool is_number = false;
};

ValueRanges::ValueRanges(Graph const &graph, FloatingPoint mode, std::vector<Interval> inputs)
    : graph_(graph),
      inputs_(std::move(inputs)),
      any_(any_value(mode)) {
  ranges_.reserve(graph.nodes.size());
  for (Node const &node : graph.nodes) ranges_.push_back(of(node, 1));
}

// Refines the range through operands up to `depth`; below that it takes the stored ranges.
Interval ValueRanges::near(NodeId id, int depth) const {
  Interval range = ranges_[id];
  if (depth > 0) meet(range, of(graph_.nodes[id], depth));
  return range;
}

Interval ValueRanges::of(Node const &node, int depth) const {
  if (node.is_constant()) {
    double const value = node.value();
    return std::isnan(value) ? any_ : Interval{value, value, false};
  }
  if (node.op == Op::input && node.slot() < inputs_.size()) return inputs_[node.slot()];
  if (is_leaf(node.op)) return any_;
  OperationInfo const &operation = info(node.op);
  if (operation.has(flag::BOOLEAN)) return {0, 1, false};
  if (operation.has(flag::OPAQUE) || operation.has(flag::WIDE)) return any_;
  if (operation.has(flag::MONOTONE)) return monotone(node, depth);
  switch (node.op) {
  case Op::select: return choice(node, Bound(), 2);
  case Op::fmin:
  case Op::fmax: return extreme(node, depth);
  case Op::sub: {
    Interval const x = operand(node, 0, depth), y = operand(node, 1, depth);
    return bounded({x.low - y.high, x.high - y.low, x.nan || y.nan});
  }
  case Op::mul:
  case Op::div:
  case Op::int_div: return corners(node, depth);
  case Op::neg: {
    Interval const x = operand(node, 0, depth);
    return {-x.high, -x.low, x.nan};
  }
  case Op::abs: return magnitude(operand(node, 0, depth));
  case Op::copysign: {
    Interval const x = magnitude(operand(node, 0, depth));
    return {-x.high, x.high, x.nan};
  }
  case Op::int32: return cut_off(node, -0x1p31, 0x1p31 - 1, depth);
  case Op::int64: return cut_off(node, -0x1p63, 0x1p63, depth);
  case Op::wrap_int32: return integer(node, -0x1p31, 0x1p31 - 1, depth);
  case Op::wrap_int8: return integer(node, -128, 127, depth);
  case Op::wrap_int16: return integer(node, -0x1p15, 0x1p15 - 1, depth);
  case Op::wrap_uint8: return integer(node, 0, 255, depth);
  case Op::wrap_uint16: return integer(node, 0, 0x1p16 - 1, depth);
  case Op::wrap_uint32: return integer(node, 0, 0x1p32 - 1, depth);
  case Op::mul_uint32:
  case Op::wide_low: return {0, 0x1p32 - 1, false};
  case Op::wide_value: return {-0x1p63, 0x1p63, false};
  case Op::wide_uvalue: return {0, 0x1p64, false};
  case Op::fmod: return rest(operand(node, 0, depth), operand(node, 1, depth));
  default: return any_;
  }
}

// A NaN bound, such as that of inf - inf, becomes the unknown range.
Interval ValueRanges::bounded(Interval const &x) const {
  if (std::isnan(x.low) || std::isnan(x.high)) return any_;
  return {std::max(x.low, any_.low), std::min(x.high, any_.high), any_.nan};
}

Interval ValueRanges::monotone(Node const &node, int depth) const {
  double low[3] = {}, high[3] = {};
  for (unsigned k = 0; k < info(node.op).arity; ++k) {
    Interval const range = operand(node, k, depth);
    low[k] = range.low;
    high[k] = range.high;
  }
  return bounded({evaluate(node.op, low[0], low[1], low[2]), evaluate(node.op, high[0], high[1], high[2]), any_.nan});
}

// Conversion of a number to an integer type; undefined if it is out of range.
Interval ValueRanges::cut_off(Node const &node, double low, double high, int depth) const {
  Interval const x = operand(node, 0, depth);
  if (!(x.low <= high && x.high >= low)) return {low, high, false};
  return {std::trunc(std::max(x.low, low)), std::trunc(std::min(x.high, high)), false};
}

// The low bits of an integer: the integer itself if the type holds it, else the whole range of the type.
Interval ValueRanges::integer(Node const &node, double low, double high, int depth) const {
  Interval const x = operand(node, 0, depth);
  if (x.nan || !(x.low >= low && x.high <= high)) return {low, high, false};
  return {std::trunc(x.low), std::trunc(x.high), false};
}

// Products and quotients have their extrema at the corners of the ranges.
Interval ValueRanges::corners(Node const &node, int depth) const {
  Interval const x = operand(node, 0, depth), y = operand(node, 1, depth);
  bool const x_has_zero = x.low <= 0 && x.high >= 0, y_has_zero = y.low <= 0 && y.high >= 0;
  if (node.op != Op::mul && y_has_zero) return any_;
  auto is_bounded = [](Interval const &range) { return std::isfinite(range.low) && std::isfinite(range.high); };
  if (node.op == Op::mul && ((x_has_zero && !is_bounded(y)) || (y_has_zero && !is_bounded(x)))) return any_;
  Interval result{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), x.nan || y.nan};
  for (double a : {x.low, x.high})
    for (double b : {y.low, y.high}) {
      double const value = evaluate(node.op, a, b, 0);
      if (std::isnan(value)) return any_;
      result = {std::min(result.low, value), std::max(result.high, value), result.nan};
    }
  return bounded(result);
}

// fmin and fmax, which return the other operand if one is NaN.
Interval ValueRanges::extreme(Node const &node, int depth) const {
  Interval const x = operand(node, 0, depth), y = operand(node, 1, depth);
  if (x.nan || y.nan) return {std::min(x.low, y.low), std::max(x.high, y.high), x.nan && y.nan};
  if (node.op == Op::fmin) return {std::min(x.low, y.low), std::min(x.high, y.high), false};
  return {std::max(x.low, y.low), std::max(x.high, y.high), false};
}

// fmod has the sign of x and a magnitude below that of y.
Interval ValueRanges::rest(Interval const &x, Interval const &y) const {
  double const limit = std::max(std::fabs(y.low), std::fabs(y.high));
  if (limit == 0) return any_;
  double const below = std::nextafter(limit, 0.0);
  return bounded({x.low < 0 ? -std::min(below, -x.low) : 0, x.high > 0 ? std::min(below, x.high) : 0, any_.nan});
}

// Union of both arms, each under the bound that the condition implies, as in x < 0 ? 0 : x. A nested select in an arm
// may depend on the compared node, as in x < 0 ? 0 : (1 < x ? 1 : x); one level of nesting is analysed.
Interval ValueRanges::choice(Node const &node, Bound const &outer, int depth) const {
  Interval const y = arm(node, 1, outer, depth), z = arm(node, 2, outer, depth);
  return {std::min(y.low, z.low), std::max(y.high, z.high), y.nan || z.nan};
}

Interval ValueRanges::arm(Node const &node, unsigned k, Bound const &outer, int depth) const {
  NodeId const id = node.operand[k];
  Interval range = ranges_[id];
  for (Bound const &bound :
       {outer, bound_of(node.operand[0], k == 1, true), bound_of(node.operand[0], k == 1, false)}) {
    if (bound.node == no_node) continue;
    if (depth > 0 && graph_.nodes[id].op == Op::select) meet(range, choice(graph_.nodes[id], bound, depth - 1));
    if (bound.node == id) meet(range, {bound.low, bound.high, !bound.is_number});
  }
  return range;
}

// Bound of the left or right operand that a comparison implies if it holds, or fails.
ValueRanges::Bound ValueRanges::bound_of(NodeId condition, bool holds, bool is_left) const {
  Node const *node = &graph_.nodes[condition];
  for (; node->op == Op::logical_not; node = &graph_.nodes[node->operand[0]]) holds = !holds;
  bool const less = node->op == Op::lt || node->op == Op::le, greater = node->op == Op::gt || node->op == Op::ge;
  if (!less && !greater) return Bound();
  Bound bound{.node = node->operand[is_left ? 0 : 1], .is_number = holds};
  Interval const &other = ranges_[node->operand[is_left ? 1 : 0]];
  if ((less == is_left) == holds)
    bound.high = other.high;
  else
    bound.low = other.low;
  return bound;
}

} // namespace symreal
