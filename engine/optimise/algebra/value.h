// Value of an expression at random points, three over a prime field and two in extended precision. By the
// Schwartz-Zippel lemma two different rational expressions are equal at a random point with probability at most
// degree/prime; extended precision confirms the field's verdict.
//
// The field has angles as points of the unit circle. A pseudorandom function of an angle's value gives its point.
// Related angles are the exception: for integer combinations of others or of their quarters the point is the product of
// those points. So the field satisfies sin(a + b) = sin(a) cos(b) + cos(a) sin(b), and structure recovery finds it like
// any other identity.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <unordered_map>

namespace symreal::algebra {

// Prime-field arithmetic.
//
// A safe prime, so (prime - 1) / 2 is prime too, and 2 generates the group: the powers of 2 in doubles stay distinct.
// (Modulo 2^61 - 1, which is faster, 2^61 would be 1.)
inline constexpr std::uint64_t prime_offset = 2373;
inline constexpr std::uint64_t prime = (std::uint64_t{1} << 61) - prime_offset;

// A field element, 0 <= value < prime.
using Residue = std::uint64_t;

inline Residue add(Residue a, Residue b) {
  Residue const sum = a + b;
  return sum >= prime ? sum - prime : sum;
}
inline Residue negate(Residue a) { return a == 0 ? 0 : prime - a; }
inline Residue subtract(Residue a, Residue b) { return add(a, negate(b)); }
inline Residue multiply(Residue a, Residue b) {
  constexpr std::uint64_t low = (std::uint64_t{1} << 61) - 1;
  __extension__ using Wide = unsigned __int128;
  Wide const product = static_cast<Wide>(a) * b;
  // 2^61 is congruent to prime_offset. The second round leaves less than 2^61 + 2^24.
  Wide const once = static_cast<Wide>(static_cast<std::uint64_t>(product >> 61)) * prime_offset +
                    (static_cast<std::uint64_t>(product) & low);
  std::uint64_t const twice =
      static_cast<std::uint64_t>(once >> 61) * prime_offset + (static_cast<std::uint64_t>(once) & low);
  return twice >= prime ? twice - prime : twice;
}
Residue power(Residue base, std::uint64_t exponent);
// Inverse; 0 for 0.
Residue inverse(Residue a);
// Inverts each element at the cost of one inverse and three products per element.
void invert(std::span<Residue> all);

// Canonical representative of a and -a.
inline Residue magnitude(Residue a) { return a <= prime / 2 ? a : prime - a; }

// Residue of a finite double, which is an integer times a power of 2.
Residue residue_of(double value);

// Hash of a word (the finaliser of SplitMix64).
inline std::uint64_t mixed(std::uint64_t bits) {
  bits ^= bits >> 30;
  bits *= 0xbf58476d1ce4e5b9u;
  bits ^= bits >> 27;
  bits *= 0x94d049bb133111ebu;
  return bits ^ bits >> 31;
}
// Pseudorandom nonzero element, a function of the key.
Residue random_residue(std::uint64_t key);

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

// The angle times quarters / 4.
struct AnglePart {
  Value angle;
  int quarters;
};

class Angles {
public:
  Value sine(Value const &angle) const;
  Value cosine(Value const &angle) const;

  // Makes the product of the parts' points the point of their sum `sum`.
  void add(Value const &sum, std::span<AnglePart const> parts);
  // Sets the point of an angle.
  void set(Value const &angle, Value const &sine, Value const &cosine);

private:
  struct Point {
    std::array<Residue, field_points> angle, sine, cosine;
  };
  Point const *find(Value const &angle) const;

  std::unordered_map<std::uint64_t, Point> points_; // keyed by Value::key
};

} // namespace symreal::algebra
