#include "engine/optimise/algebra/value.h"

#include <cstdlib>
#include <utility>
#include <vector>

namespace symreal::algebra {

namespace {

template <class Field, class Number> Value each(Field const &field, Number const &number) {
  Value result{};
  for (std::size_t k = 0; k < field_points; ++k) result.field[k] = field(k);
  for (std::size_t k = 0; k < number_points; ++k) result.number[k] = number(k);
  return result;
}

// Pseudorandom number between 0.3 and 1.3.
long double random_number(std::uint64_t key) {
  return 0.3L + static_cast<long double>(mixed(key * 31 + 0x51ED2701u) >> 11) * 0x1p-53L;
}

Residue parameter_of_circle(Residue angle) {
  Residue const t = random_residue(magnitude(angle) ^ 0x55555u);
  return angle == 0 ? 0 : t;
}

// Point of the unit circle; the product of two is that of the sum of their angles.
struct Rotation {
  Residue sine = 0, cosine = 1;

  Rotation operator*(Rotation const &b) const {
    return {add(multiply(sine, b.cosine), multiply(cosine, b.sine)),
            subtract(multiply(cosine, b.cosine), multiply(sine, b.sine))};
  }
  Rotation operator-() const { return {negate(sine), cosine}; }
};

Rotation power(Rotation base, int exponent) {
  if (exponent < 0) base = -base;
  Rotation result;
  for (int k = 0; k < std::abs(exponent); ++k) result = result * base;
  return result;
}

} // namespace

Residue power(Residue base, std::uint64_t exponent) {
  Residue result = 1;
  for (; exponent != 0; exponent >>= 1) {
    if (exponent & 1) result = multiply(result, base);
    base = multiply(base, base);
  }
  return result;
}

// Extended Euclidean algorithm.
Residue inverse(Residue a) {
  std::int64_t multiple = 0, next_multiple = 1;
  std::uint64_t remainder = prime, next = a;
  while (next != 0) {
    std::uint64_t const quotient = remainder / next;
    multiple = std::exchange(next_multiple, multiple - static_cast<std::int64_t>(quotient) * next_multiple);
    remainder = std::exchange(next, remainder - quotient * next);
  }
  if (a == 0) return 0;
  return multiple < 0 ? static_cast<Residue>(multiple + static_cast<std::int64_t>(prime))
                      : static_cast<Residue>(multiple);
}

// Montgomery's trick: prefix products, one inverse, then back.
void invert(std::span<Residue> all) {
  std::vector<Residue> before;
  before.reserve(all.size());
  Residue product = 1;
  for (Residue const a : all) {
    before.push_back(product);
    if (a != 0) product = multiply(product, a);
  }
  Residue rest = inverse(product);
  for (std::size_t k = all.size(); k-- > 0;)
    if (all[k] != 0) rest = multiply(rest, std::exchange(all[k], multiply(rest, before[k])));
}

Residue residue_of(double value) {
  int exponent = 0;
  double const fraction = std::frexp(std::fabs(value), &exponent);
  auto const integer = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  exponent -= 53;
  Residue const two = exponent < 0 ? (prime + 1) / 2 : 2;
  Residue const result = multiply(integer % prime, power(two, static_cast<std::uint64_t>(std::abs(exponent))));
  return std::signbit(value) ? negate(result) : result;
}

Residue random_residue(std::uint64_t key) {
  std::uint64_t const bits = mixed(mixed(key + 0x9E3779B97F4A7C15u) ^ 0x1234567u) % prime;
  return bits == 0 ? 7 : bits;
}

Value value_of(double constant) {
  Residue const residue = residue_of(constant);
  return each([&](std::size_t) { return residue; }, [&](std::size_t) { return static_cast<long double>(constant); });
}

Value random_value(std::uint64_t key) {
  return each([&](std::size_t k) { return random_residue(mixed(key) + k * 1000003); },
              [&](std::size_t k) { return random_number(mixed(key) + k * 1000003); });
}

Value random_parameter(std::uint64_t key) {
  return each([&](std::size_t k) { return random_residue(mixed(key ^ 0x7777777777u) + (k == 2 ? 1000003 : 0)); },
              [&](std::size_t k) { return random_number(mixed(key ^ 0x7777777777u) + k * 1000003); });
}

Value operator-(Value const &a) {
  return each([&](std::size_t k) { return negate(a.field[k]); }, [&](std::size_t k) { return -a.number[k]; });
}
Value operator+(Value const &a, Value const &b) {
  return each([&](std::size_t k) { return add(a.field[k], b.field[k]); },
              [&](std::size_t k) { return a.number[k] + b.number[k]; });
}
Value operator*(Value const &a, Value const &b) {
  return each([&](std::size_t k) { return multiply(a.field[k], b.field[k]); },
              [&](std::size_t k) { return a.number[k] * b.number[k]; });
}
Value inverse(Value const &a) {
  return each([&](std::size_t k) { return inverse(a.field[k]); }, [&](std::size_t k) { return 1 / a.number[k]; });
}

Value sine(Value const &a) {
  return each(
      [&](std::size_t k) {
        Residue const t = parameter_of_circle(a.field[k]);
        Residue const s = multiply(multiply(2, t), inverse(add(1, multiply(t, t))));
        return magnitude(a.field[k]) == a.field[k] ? s : negate(s);
      },
      [&](std::size_t k) { return sinl(a.number[k]); });
}
Value cosine(Value const &a) {
  return each(
      [&](std::size_t k) {
        Residue const square = multiply(parameter_of_circle(a.field[k]), parameter_of_circle(a.field[k]));
        return multiply(subtract(1, square), inverse(add(1, square)));
      },
      [&](std::size_t k) { return cosl(a.number[k]); });
}

Angles::Point const *Angles::find(Value const &angle) const {
  auto const found = points_.find(angle.key());
  if (found == points_.end()) return nullptr;
  bool const is_it = found->second.angle == angle.field || found->second.angle == (-angle).field;
  return is_it ? &found->second : nullptr;
}

Value Angles::sine(Value const &angle) const {
  Value result = algebra::sine(angle);
  if (Point const *point = find(angle))
    for (std::size_t k = 0; k < field_points; ++k)
      result.field[k] = point->angle == angle.field ? point->sine[k] : negate(point->sine[k]);
  return result;
}

Value Angles::cosine(Value const &angle) const {
  Value result = algebra::cosine(angle);
  if (Point const *point = find(angle)) result.field = point->cosine;
  return result;
}

void Angles::add(Value const &sum, std::span<AnglePart const> parts) {
  Value sine{}, cosine{};
  for (std::size_t k = 0; k < field_points; ++k) {
    Rotation all;
    for (AnglePart const &part : parts) {
      // The hashed point of the part represents a quarter of it.
      Rotation const quarter = {algebra::sine(part.angle).field[k], algebra::cosine(part.angle).field[k]};
      all = all * power(quarter, part.quarters);
    }
    sine.field[k] = all.sine;
    cosine.field[k] = all.cosine;
  }
  set(sum, sine, cosine);
}

void Angles::set(Value const &angle, Value const &sine, Value const &cosine) {
  points_.insert_or_assign(angle.key(), Point{angle.field, sine.field, cosine.field});
}

} // namespace symreal::algebra
