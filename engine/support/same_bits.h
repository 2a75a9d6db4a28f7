// Bitwise comparison of numbers: 0 differs from -0, and a NaN equals itself.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace symreal {

inline bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

inline bool all_same_bits(std::vector<double> const &a, std::vector<double> const &b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_bits);
}

} // namespace symreal
