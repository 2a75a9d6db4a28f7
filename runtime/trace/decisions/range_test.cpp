#include "runtime/trace/decisions/range_test.h"

#include "engine/graph/relations.h"
#include "engine/graph/value_range.h"
#include "runtime/trace/decisions/policy.h"

#include <algorithm>
#include <map>
#include <set>

namespace symreal::trace {
namespace {

using namespace relation;

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

std::optional<bool> outcome(NodeTable const &nodes, NodeId condition, std::vector<Interval> const &inputs) {
  bool is_negated = false;
  for (; nodes[condition].op == Op::logical_not; is_negated = !is_negated) condition = nodes[condition].operand[0];
  unsigned const held = held_by(nodes[condition].op);
  if (held == 0) return std::nullopt;
  Graph const part = part_of(nodes, condition);
  if (part.nodes.empty()) return std::nullopt;
  ValueRanges const ranges(part, floating_point(), inputs);
  Node const &comparison = part.nodes.back();
  Interval const x = ranges.range(comparison.operand[0]), y = ranges.range(comparison.operand[1]);
  unsigned const possible = (x.low < y.high ? less : 0u) | (x.high > y.low ? greater : 0u) |
                            (x.low <= y.high && y.low <= x.high ? equal : 0u) | (x.nan || y.nan ? unordered : 0u);
  if ((possible & held) == 0) return is_negated;
  if ((possible & ~held) == 0) return !is_negated;
  return std::nullopt;
}

} // namespace

std::optional<bool> outcome_of_bounds(NodeTable const &nodes, NodeId condition) {
  return outcome(nodes, condition, {});
}

std::optional<bool> outcome_in_ranges(NodeTable const &nodes, NodeId condition, std::vector<Object> const &inputs) {
  if (std::ranges::none_of(inputs, [](Object const &input) { return input.range.has_value(); })) return std::nullopt;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Interval> bounds;
  for (Object const &input : inputs) {
    Interval const any{-infinity, infinity, floating_point() == FloatingPoint::strict};
    bounds.resize(input.first + input.count, input.range ? Interval{input.range->low, input.range->high, false} : any);
  }
  return outcome(nodes, condition, bounds);
}

} // namespace symreal::trace
