// Prime-field arithmetic, in which expressions are evaluated to test equality.
#pragma once

#include <cstdint>
#include <span>

namespace symreal::algebra {

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

} // namespace symreal::algebra
