#include "engine/optimise/algebra/prime_field.h"

#include <cmath>
#include <utility>
#include <vector>

namespace symreal::algebra {

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

} // namespace symreal::algebra
