#include "engine/plan/lanes/match.h"

#include <algorithm>

namespace symreal::lanes {

namespace {

constexpr int deepest_look = 3;

// Mismatch of two values in lanes at this distance: 0 for one node, or for elements at the same distance.
class Distance {
public:
  Distance(Function const &function, std::ptrdiff_t lanes) : function_(function), lanes_(lanes) {}

  double between(NodeId x, NodeId y, int depth = deepest_look) const {
    if (x == y) return 0;
    if (function_.is_constant(x) && function_.is_constant(y)) return 1;
    if (function_.is_element(x) && function_.is_element(y)) return elements(function_.element(x), function_.element(y));
    if (!function_.can_be_packed(x) || !function_.can_be_packed(y)) return unlike;
    Node const &a = function_.node(x), &b = function_.node(y);
    if (kind(a.op) != kind(b.op)) return unlike;
    if (depth == 0) return 1;
    double apart = pair(a, b, 0, 0, depth);
    if (arity(a.op) == 2) {
      apart += pair(a, b, 1, 1, depth);
      if (exchanges(a.op) || exchanges(b.op))
        apart = std::min(apart, pair(a, b, 0, 1, depth) + pair(a, b, 1, 0, depth));
    }
    return std::min(apart / 2, unlike - 1);
  }

  static Op kind(Op op) { return op == Op::sub ? Op::add : op; }
  static bool exchanges(Op op) { return op == Op::add || op == Op::mul; }

private:
  static constexpr double unlike = 8;

  double pair(Node const &a, Node const &b, std::size_t i, std::size_t k, int depth) const {
    return between(a.operand[i], b.operand[k], depth - 1);
  }
  double elements(Element x, Element y) const {
    if (x.array != y.array) return unlike;
    auto const apart = static_cast<std::ptrdiff_t>(y.index) - static_cast<std::ptrdiff_t>(x.index) - lanes_;
    return apart == 0 ? 0 : 1 + static_cast<double>(std::min<std::ptrdiff_t>(std::abs(apart), 32)) / 8;
  }

  Function const &function_;
  std::ptrdiff_t lanes_;
};

} // namespace

std::optional<Match> match(Function const &function, std::vector<NodeId> const &nodes) {
  Op const kind = Distance::kind(function.node(nodes[0]).op);
  bool all_same = true;
  for (NodeId id : nodes) {
    if (!function.can_be_packed(id) || Distance::kind(function.node(id).op) != kind) return {};
    all_same = all_same && id == nodes[0];
  }
  if (all_same) return {};
  auto const is_sub = [&](NodeId id) { return function.node(id).op == Op::sub; };
  auto const subs = std::ranges::count_if(nodes, is_sub);
  Match result{.op = subs == std::ssize(nodes) ? Op::sub : kind, .operand = {}};
  if (subs != 0 && result.op != Op::sub)
    for (NodeId id : nodes) result.subtracts.push_back(is_sub(id));
  if (arity(kind) == 1) {
    for (NodeId id : nodes) result.operand[0].push_back(function.node(id).operand[0]);
    return result;
  }
  // The operands of a difference cannot be exchanged, so the first difference, if any, determines the order for all.
  std::size_t const anchor =
      subs == 0 ? 0 : static_cast<std::size_t>(std::ranges::find_if(nodes, is_sub) - nodes.begin());
  Node const &like = function.node(nodes[anchor]);
  for (std::size_t lane = 0; lane < nodes.size(); ++lane) {
    Node const &node = function.node(nodes[lane]);
    NodeId x = node.operand[0], y = node.operand[1];
    Distance const distance(function, static_cast<std::ptrdiff_t>(lane) - static_cast<std::ptrdiff_t>(anchor));
    if (Distance::exchanges(node.op) && distance.between(like.operand[0], y) + distance.between(like.operand[1], x) <
                                            distance.between(like.operand[0], x) + distance.between(like.operand[1], y))
      std::swap(x, y);
    result.operand[0].push_back(x);
    result.operand[1].push_back(y);
  }
  return result;
}

} // namespace symreal::lanes
