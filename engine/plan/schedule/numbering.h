// Value numbering: two values have one number if they are the same operation on operands with the same numbers.
//
// Besides, only identities that are exact in floating point count: sums and products commute, x - y is x + (-y), and
// signs move through products and quotients. Values with one number are thus bitwise equal, except that any NaN equals
// any other. If zeros have no sign, signs also move through sums, and sums of opposites and products with 0 are 0.
//
// Method: numbers are the nodes of a hash-consed graph that holds each value in one canonical form.
#pragma once

#include "engine/graph/node_table.h"

namespace symreal {

// The number of a value, and whether the value is its negative.
struct NumberedValue {
  NodeId number = no_node;
  bool negated = false;

  NumberedValue operator-() const { return {number, !negated}; }
  bool operator==(NumberedValue const &) const = default;
  bool is_known() const { return number != no_node; }
};

class Numbering {
public:
  explicit Numbering(bool zeros_have_signs = true);

  NumberedValue constant(double value);
  // Number of an array element.
  NumberedValue element(std::uint32_t array, std::size_t index);
  // Number of an operation; unknown if an operand is.
  NumberedValue operation(Op op, std::array<NumberedValue, 3> operands);

private:
  NodeId number(Op op, std::array<NodeId, 3> operands);
  NodeId with_sign(NumberedValue value);
  NumberedValue sum(NumberedValue x, NumberedValue y);
  NumberedValue product(Op op, NumberedValue x, NumberedValue y);

  bool zeros_have_signs_;
  NodeTable values_;
  NumberedValue zero_, one_;
};

} // namespace symreal
