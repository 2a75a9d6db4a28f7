// The value of an expression at random points: at three over a prime field, at two in extended precision. By the lemma
// of Schwartz and Zippel two rational expressions that differ are equal at a random point with probability degree/prime
// at most; the extended precision confirms what the field says.
#pragma once

#include "engine/optimise/algebra/prime_field.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace symreal::algebra {

// Points 0 and 1 have the same parameters and other inputs; point 2 has other parameters.
inline constexpr std::size_t field_points = 3, number_points = 2;

struct Value {
  std::array<Residue, field_points> field;
  std::array<long double, number_points> number;

  bool is_zero() const { return field[0] == 0 && field[1] == 0 && field[2] == 0; }
  // The same for a value and its negative.
  std::uint64_t key() const { return magnitude(field[0]); }
};

Value value_of(double constant);
// Of an input, by its slot or whatever tells it from others; of something opaque, by what it is made of.
Value random_value(std::uint64_t key);
Value random_parameter(std::uint64_t key);

Value operator-(Value const &a);
Value operator+(Value const &a, Value const &b);
Value operator*(Value const &a, Value const &b);
Value inverse(Value const &a);
// A point of the unit circle that depends on the angle alone: with t = hash(a), 2t / (1 + t^2) and (1 - t^2) / (1 +
// t^2). So the squares add up to 1, and the sine is odd, the cosine even.
Value sine(Value const &a);
Value cosine(Value const &a);

inline bool equal_in_field(Value const &a, Value const &b) { return a.field == b.field; }
// Whether a and b are equal but for rounding, where numbers of the magnitude `scale` went into them.
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
// Whether it is one number at all points.
inline bool is_number(Value const &a) {
  return a.field[0] == a.field[1] && a.field[0] == a.field[2] &&
         std::fabs(a.number[0] - a.number[1]) <= 0x1p-50L * std::fabs(a.number[0]);
}

} // namespace symreal::algebra
