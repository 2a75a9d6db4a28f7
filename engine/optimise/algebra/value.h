// Value of an expression at random points, three over a prime field and two in extended precision. By the
// Schwartz-Zippel lemma two different rational expressions are equal at a random point with probability at most
// degree/prime; extended precision confirms the field's verdict.
#pragma once

#include "engine/optimise/algebra/prime_field.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace symreal::algebra {

// Points 0 and 1 share the parameters and differ in the inputs; point 2 differs in the parameters.
inline constexpr std::size_t field_points = 3, number_points = 2;

struct Value {
  std::array<Residue, field_points> field;
  std::array<long double, number_points> number;

  bool is_zero() const { return field[0] == 0 && field[1] == 0 && field[2] == 0; }
  // Hash key, equal for a value and its negative.
  std::uint64_t key() const { return magnitude(field[0]); }
};

Value value_of(double constant);
// Value of an input or opaque node, a function of its key.
Value random_value(std::uint64_t key);
Value random_parameter(std::uint64_t key);

Value operator-(Value const &a);
Value operator+(Value const &a, Value const &b);
Value operator*(Value const &a, Value const &b);
Value inverse(Value const &a);
// Point of the unit circle as a function of the angle: with t = hash(a), 2t / (1 + t^2) and (1 - t^2) / (1 + t^2). So
// the squares add up to 1, and the sine is odd, the cosine even.
Value sine(Value const &a);
Value cosine(Value const &a);

inline bool equal_in_field(Value const &a, Value const &b) { return a.field == b.field; }
// Whether a and b are equal up to rounding, for operands of magnitude `scale`.
inline bool confirmed(Value const &a, Value const &b, long double scale) {
  constexpr long double tolerance = 0x1p-34L;
  for (std::size_t k = 0; k < number_points; ++k) {
    long double const size = std::fmax(scale, std::fmax(std::fabs(a.number[k]), std::fabs(b.number[k])));
    if (!(std::fabs(a.number[k] - b.number[k]) <= tolerance * size)) return false;
  }
  return true;
}
inline long double scale_of(Value const &a) {
  long double scale = 0;
  for (long double number : a.number) scale = std::fmax(scale, std::fabs(number));
  return scale;
}
// Whether the value is the same number at all points.
inline bool is_number(Value const &a) {
  return a.field[0] == a.field[1] && a.field[0] == a.field[2] &&
         std::fabs(a.number[0] - a.number[1]) <= 0x1p-50L * std::fabs(a.number[0]);
}

} // namespace symreal::algebra
