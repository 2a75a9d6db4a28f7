#include "runtime/trace/decisions/zero_test.h"

#include <limits>

namespace symreal::trace {
namespace {

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
