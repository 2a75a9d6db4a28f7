// Numbers of values: two values have one number if they are the same operation of values with the same numbers.
//
// Known besides is only what is exact in floating point: that sums and products commute, x - y is x + (-y), and signs
// go through products and quotients. So what has one number is the same, bit by bit, any NaN taken for any other. Where
// zeros have no sign, signs go through sums as well, sums of opposites are 0, and so are products with 0.
//
// Method: the numbers are those of the nodes of a hash consed graph that holds each value in one form.
#pragma once

#include "engine/graph/node_table.h"

namespace symreal {

// The number of a value and whether its sign is the other one.
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
  // Of an element of an array.
  NumberedValue element(std::uint32_t array, std::size_t index);
  // Known if its operands are.
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
