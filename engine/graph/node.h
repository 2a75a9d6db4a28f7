// One node of a recorded computation.
#pragma once

#include "engine/ops/operation.h"
#include "engine/support/page_allocator.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace symreal {

// Index of a node in its graph. Order is topological: operands precede their users.
using NodeId = std::uint32_t;
inline constexpr NodeId no_node = ~NodeId{0};

// Dependence of a node: on constants only, on parameters, or on an input variable.
// The order matters: the attribute of a node is the maximum over its operands.
enum class Attribute : std::uint8_t { constant, parametric, variable };

// A node in 16 bytes. A constant keeps the bits of its double in two operand fields, an input or parameter its slot in
// one, so that every kind of node is compared and hashed as the same four words.
struct Node {
  Op op;
  Attribute attribute;
  std::array<NodeId, 3> operand;

  // Comparison by words; std::array's own is a call of memcmp.
  bool operator==(Node const &other) const {
    return op == other.op && operand[0] == other.operand[0] && operand[1] == other.operand[1] &&
           operand[2] == other.operand[2] && attribute == other.attribute;
  }

  static Node constant(double value) {
    auto bits = std::bit_cast<std::uint64_t>(value);
    return {Op::constant, Attribute::constant, {static_cast<NodeId>(bits), static_cast<NodeId>(bits >> 32), no_node}};
  }
  static Node input(std::uint32_t slot) { return {Op::input, Attribute::variable, {slot, no_node, no_node}}; }
  static Node parameter(std::uint32_t slot) { return {Op::parameter, Attribute::parametric, {slot, no_node, no_node}}; }

  bool is_constant() const { return op == Op::constant; }
  double value() const { return std::bit_cast<double>(std::uint64_t{operand[1]} << 32 | operand[0]); }
  std::uint32_t slot() const { return operand[0]; }
};
static_assert(sizeof(Node) == 16);
using Nodes = LongArray<Node>;

// Attribute of an operation whose operands have at most this one. Opaque operations are at least parametric, since
// their results are unknown here; operations with effects are variable, since they run whenever the program does.
inline Attribute attribute_of(Op op, Attribute operands) {
  if (info(op).has(flag::EFFECT)) return Attribute::variable;
  return info(op).has(flag::OPAQUE) ? std::max(operands, Attribute::parametric) : operands;
}

} // namespace symreal
