#include "runtime/trace/decisions/known_outcomes.h"

#include "engine/graph/relations.h"

#include <algorithm>
#include <cmath>

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

} // namespace

std::optional<bool> KnownOutcomes::outcome(NodeTable const &nodes, NodeId condition) const {
  auto const [id, is_negated] = without_not(nodes, condition);
  if (auto const found = outcomes_.find(id); found != outcomes_.end()) return found->second != is_negated;
  Node const &node = nodes[id];
  unsigned const held = held_by(node.op);
  if (held == 0) return std::nullopt;
  Relations const possible = relations(nodes, {node.operand[0], node.operand[1]});
  if ((possible & held) == 0) return is_negated;
  if ((possible & ~held) == 0) return !is_negated;
  return std::nullopt;
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

} // namespace symreal::trace
