// Numbers of values: two values have one number if they are the same operation of values with the same numbers.
//
// Known besides is only what is exact in floating point: that sums and products commute, x - y is x + (-y), and signs
// go through products and quotients. So what has one number is the same, bit by bit, any NaN taken for any other. Where
// zeros have no sign, signs go through sums as well, sums of opposites are 0, and so are products with 0.
#pragma once

#include "graph/graph.h"

#include <unordered_map>

namespace symreal {

// The number of a value and whether its sign is the other one.
struct NumberedValue {
  std::uint32_t number = ~std::uint32_t{0};
  bool negated = false;

  NumberedValue operator-() const { return {number, !negated}; }
  bool operator==(NumberedValue const &) const = default;
  bool is_known() const { return number != ~std::uint32_t{0}; }
  std::uint64_t word() const { return std::uint64_t{number} << 1 | (negated ? 1 : 0); }
};

class Numbering {
public:
  explicit Numbering(bool zeros_have_signs = true) : zeros_have_signs_(zeros_have_signs) {}

  NumberedValue constant(double value);
  // Of an element of an array.
  NumberedValue element(std::uint32_t array, std::size_t index);
  NumberedValue operation(Op op, std::array<NumberedValue, 3> operands);

private:
  using Key = std::array<std::uint64_t, 4>;
  struct Hash {
    std::size_t operator()(Key const &key) const;
  };
  std::uint32_t number(Key const &key);
  NumberedValue sum(NumberedValue x, NumberedValue y);
  NumberedValue product(Op op, NumberedValue x, NumberedValue y);

  bool zeros_have_signs_;
  std::unordered_map<Key, std::uint32_t, Hash> numbers_;
};

} // namespace symreal
