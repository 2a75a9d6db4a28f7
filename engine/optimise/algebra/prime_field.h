// Arithmetic modulo a prime: where expressions are evaluated to find out whether they are equal.
#pragma once

#include <cstdint>
#include <span>

namespace symreal::algebra {

// A safe prime, (prime - 1) / 2 being one as well, and 2 generates all of the group: the powers of 2 that a double
// consists of are told apart. (Modulo 2^61 - 1, which is quicker, 2^61 would be 1.)
inline constexpr std::uint64_t prime_offset = 2373;
inline constexpr std::uint64_t prime = (std::uint64_t{1} << 61) - prime_offset;

// An element, 0 <= value < prime.
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
  // 2^61 is prime_offset. After the second round less than 2^61 + 2^24 is left.
  Wide const once = static_cast<Wide>(static_cast<std::uint64_t>(product >> 61)) * prime_offset +
                    (static_cast<std::uint64_t>(product) & low);
  std::uint64_t const twice =
      static_cast<std::uint64_t>(once >> 61) * prime_offset + (static_cast<std::uint64_t>(once) & low);
  return twice >= prime ? twice - prime : twice;
}
Residue power(Residue base, std::uint64_t exponent);
// Of 0 it is 0.
Residue inverse(Residue a);
// The same of each, in the time of one inverse and three products each.
void invert(std::span<Residue> all);

// The same for a and -a.
inline Residue magnitude(Residue a) { return a <= prime / 2 ? a : prime - a; }

// A finite double is a rational number: an integer times a power of 2.
Residue residue_of(double value);

// Spreads the bits of a number over all of a word.
inline std::uint64_t mixed(std::uint64_t bits) {
  bits ^= bits >> 30;
  bits *= 0xbf58476d1ce4e5b9u;
  bits ^= bits >> 27;
  bits *= 0x94d049bb133111ebu;
  return bits ^ bits >> 31;
}
// An element that looks random, the same for the same key; not 0.
Residue random_residue(std::uint64_t key);

} // namespace symreal::algebra
