#include "runtime/trace/decisions/known_outcomes.h"

#include "engine/graph/value_range.h"
#include "engine/ops/operation.h"
#include "runtime/trace/decisions/decisions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace symreal::trace {
namespace {

using namespace relation;

bool is_nan(Node const &node) { return node.is_constant() && std::isnan(node.value()); }

// The condition behind any number of negations.
std::pair<NodeId, bool> without_not(NodeTable const &nodes, NodeId condition) {
  bool is_negated = false;
  for (; nodes[condition].op == Op::logical_not; is_negated = !is_negated) condition = nodes[condition].operand[0];
  return {condition, is_negated};
}

// The outcome of a condition, negated or not, that holds in the relations `held`, if only `possible` ones are left.
std::optional<bool> implied(unsigned possible, unsigned held, bool is_negated) {
  if ((possible & held) == 0) return is_negated;
  if ((possible & ~held) == 0) return !is_negated;
  return std::nullopt;
}

// The condition, as the last node, with the nodes that it depends on. The search is bounded.
Graph part_of(NodeTable const &nodes, NodeId condition) {
  constexpr std::size_t most = 4000;
  std::set<NodeId> met;
  std::vector<NodeId> open = {condition};
  while (!open.empty() && met.size() < most) {
    NodeId const id = open.back();
    open.pop_back();
    if (!met.insert(id).second || is_leaf(nodes[id].op)) continue;
    for (NodeId operand : nodes[id].operand)
      if (operand != no_node) open.push_back(operand);
  }
  Graph part;
  if (!open.empty()) return part;
  std::map<NodeId, NodeId> now;
  for (NodeId id : met) {
    Node node = nodes[id];
    if (!is_leaf(node.op))
      for (NodeId &operand : node.operand)
        if (operand != no_node) operand = now[operand];
    now[id] = static_cast<NodeId>(part.nodes.size());
    part.nodes.push_back(node);
  }
  return part;
}

std::optional<bool> outcome_within(NodeTable const &nodes, NodeId condition, std::vector<Interval> const &inputs) {
  auto const [id, is_negated] = without_not(nodes, condition);
  unsigned const held = held_by(nodes[id].op);
  if (held == 0) return std::nullopt;
  Graph const part = part_of(nodes, id);
  if (part.nodes.empty()) return std::nullopt;
  ValueRanges const ranges(part, floating_point(), inputs);
  Node const &comparison = part.nodes.back();
  Interval const x = ranges.range(comparison.operand[0]), y = ranges.range(comparison.operand[1]);
  unsigned const possible = (x.low < y.high ? less : 0u) | (x.high > y.low ? greater : 0u) |
                            (x.low <= y.high && y.low <= x.high ? equal : 0u) | (x.nan || y.nan ? unordered : 0u);
  return implied(possible, held, is_negated);
}

bool is_zero(Node const &node) { return node.is_constant() && node.value() == 0; }

// Whether the constant is at most the smallest normal number, which libraries treat as "0".
bool is_tiny(Node const &node) {
  return node.is_constant() && node.value() >= 0 && node.value() <= std::numeric_limits<double>::min();
}

// Whether the node is non-negative for all operands: a magnitude, a sum of squares. The search is bounded.
bool is_never_negative(NodeTable const &nodes, NodeId id, int depth = 16) {
  Node const &node = nodes[id];
  auto const operand = [&](int k) { return is_never_negative(nodes, node.operand[k], depth - 1); };
  switch (node.op) {
  case Op::abs:
  case Op::sqrt: return true;
  case Op::mul: return node.operand[0] == node.operand[1] || (depth > 0 && operand(0) && operand(1));
  case Op::add:
  case Op::div: return depth > 0 && operand(0) && operand(1);
  case Op::constant: return node.value() >= 0;
  default: return false;
  }
}

bool is_given(Node const &node) { return node.op == Op::input || node.op == Op::parameter; }

} // namespace

std::optional<bool> KnownOutcomes::outcome(NodeTable const &nodes, NodeId condition) const {
  auto const [id, is_negated] = without_not(nodes, condition);
  if (auto const found = outcomes_.find(id); found != outcomes_.end()) return found->second != is_negated;
  Node const &node = nodes[id];
  unsigned const held = held_by(node.op);
  if (held == 0) return std::nullopt;
  Relations const possible = relations(nodes, {node.operand[0], node.operand[1]});
  return implied(possible, held, is_negated);
}

void KnownOutcomes::add(NodeTable const &nodes, NodeId condition, bool outcome) {
  auto const [id, is_negated] = without_not(nodes, condition);
  bool const holds = outcome != is_negated;
  outcomes_[id] = holds;
  Node const &node = nodes[id];
  unsigned const held = held_by(node.op);
  if (held == 0) return;
  auto const [x, y] = Pair(node.operand[0], node.operand[1]);
  Relations const left = relations(nodes, {x, y}) & (holds ? held : ~held);
  left_[std::minmax(x, y)] = x <= y ? left : mirrored(left);
  for (NodeId one : {x, y})
    if (nodes[one].is_constant()) constants_.push_back(one);
}

KnownOutcomes::Relations KnownOutcomes::relations(NodeTable const &nodes, Pair pair) const {
  auto const [x, y] = pair;
  bool const with_nan = with_nan_ || is_nan(nodes[x]) || is_nan(nodes[y]);
  Relations possible = (x == y ? equal : less | equal | greater) | (with_nan ? unordered : 0);
  if (auto const found = left_.find(std::minmax(x, y)); found != left_.end())
    possible &= x <= y ? found->second : mirrored(found->second);
  if (Order const up = order(nodes, x, y); up != Order::unknown) possible &= up == Order::less ? less : less | equal;
  if (Order const down = order(nodes, y, x); down != Order::unknown)
    possible &= down == Order::less ? greater : greater | equal;
  return possible;
}

// Follows known relations upwards from `from`. Each number met keeps its strongest order.
KnownOutcomes::Order KnownOutcomes::order(NodeTable const &nodes, NodeId from, NodeId to) const {
  if (from == to) return Order::unknown;
  std::map<NodeId, Order> met = {{from, Order::at_most}};
  bool grows = true;
  auto const step = [&](NodeId low, NodeId high, Order order) {
    auto const found = met.find(low);
    if (found == met.end()) return;
    Order &now = met[high];
    Order const better = std::max(found->second, order);
    grows = grows || better > now;
    now = std::max(now, better);
  };
  std::vector<NodeId> constants = constants_;
  for (NodeId end : {from, to})
    if (nodes[end].is_constant()) constants.push_back(end);
  while (grows) {
    grows = false;
    for (auto const &[pair, left] : left_) {
      auto const [x, y] = pair;
      if (left != 0 && (left & ~(less | equal)) == 0) step(x, y, left == less ? Order::less : Order::at_most);
      if (left != 0 && (left & ~(greater | equal)) == 0) step(y, x, left == greater ? Order::less : Order::at_most);
    }
    for (NodeId low : constants)
      for (NodeId high : constants)
        if (nodes[low].value() < nodes[high].value())
          step(low, high, Order::less);
        else if (low != high && nodes[low].value() == nodes[high].value()) // 0 and -0
          step(low, high, Order::at_most);
  }
  auto const found = met.find(to);
  return found == met.end() ? Order::unknown : found->second;
}

std::optional<bool> outcome_of_bounds(NodeTable const &nodes, NodeId condition) {
  return outcome_within(nodes, condition, {});
}

std::optional<bool> outcome_in_ranges(NodeTable const &nodes, NodeId condition, std::vector<Object> const &inputs) {
  if (std::ranges::none_of(inputs, [](Object const &input) { return input.range.has_value(); })) return std::nullopt;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Interval> bounds;
  for (Object const &input : inputs) {
    Interval const any{-infinity, infinity, floating_point() == FloatingPoint::strict};
    bounds.resize(input.first + input.count, input.range ? Interval{input.range->low, input.range->high, false} : any);
  }
  return outcome_within(nodes, condition, bounds);
}

std::optional<bool> outcome_without_zero(NodeTable const &nodes, NodeId condition) {
  Node const &node = nodes[condition];
  if (node.op == Op::logical_not) {
    std::optional<bool> const inner = outcome_without_zero(nodes, node.operand[0]);
    return inner ? std::optional(!*inner) : inner;
  }
  if (is_leaf(node.op) || node.operand[1] == no_node) return std::nullopt;
  NodeId left = node.operand[0], right = node.operand[1];
  Op op = node.op;
  if (nodes[left].is_constant()) { // 0 < x is x > 0
    std::swap(left, right);
    op = op == Op::lt ? Op::gt : op == Op::gt ? Op::lt : op == Op::le ? Op::ge : op == Op::ge ? Op::le : op;
  }
  if (nodes[left].is_constant() || is_given(nodes[left])) return std::nullopt;
  if ((op == Op::eq || op == Op::ne) && is_zero(nodes[right])) return op == Op::ne;
  if (!is_tiny(nodes[right]) || !is_never_negative(nodes, left)) return std::nullopt;
  bool const includes_zero = !is_zero(nodes[right]); // x < DBL_MIN holds for 0, x < 0 does not
  if (op == Op::gt || (op == Op::ge && includes_zero)) return true;
  if (op == Op::le || (op == Op::lt && includes_zero)) return false;
  return std::nullopt;
}

} // namespace symreal::trace
