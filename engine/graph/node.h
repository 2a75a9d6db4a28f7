// One node of a recorded computation.
#pragma once

#include "engine/ops/operation.h"
#include "engine/support/page_allocator.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace symreal {

// Index of a node in its graph. Ids are topological: operands are older than their users.
using NodeId = std::uint32_t;
inline constexpr NodeId no_node = ~NodeId{0};

// An expression of constants is constant, of constants and parameters parametric, with any input variable.
// The order matters: the attribute of a node is the maximum over its operands.
enum class Attribute : std::uint8_t { constant, parametric, variable };

// 16 bytes. A constant keeps the bits of its double in two operand fields, an input or parameter its slot in one, so
// that every kind of node is compared and hashed as the same four words.
struct Node {
  Op op;
  Attribute attribute;
  std::array<NodeId, 3> operand;

  // As words: the array's own comparison is a call of memcmp.
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

// The attribute of an operation whose operands have at most this one. What stands behind an opaque operation is not
// known here, so it is no constant; what has an effect runs whenever the program does.
inline Attribute attribute_of(Op op, Attribute operands) {
  if (info(op).has(flag::EFFECT)) return Attribute::variable;
  return info(op).has(flag::OPAQUE) ? std::max(operands, Attribute::parametric) : operands;
}

} // namespace symreal
