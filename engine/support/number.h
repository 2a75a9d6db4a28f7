// Conversion of numbers to text that reads back to the same bits, and comparison of bits.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// The shortest decimal text that reads back to the same double: "10", "-0", "0.1", "1e+300", "inf", "nan"; of a NaN
// only the sign is kept.
std::string shortest(double value);
// The shortest text that reads back to the same float: "0.1" for the float 0.10000000149011612.
std::string shortest(float value);

// Inverse of shortest; also parses hexadecimal floating point ("0x1.8p+1"). Nullopt unless the whole text is a number.
std::optional<double> parse_number(std::string_view text);

// Appends the decimal text of a count to `text`.
void append_number(std::string &text, std::size_t number);

// Bitwise comparison of numbers: 0 differs from -0, and a NaN equals itself.

inline bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

inline bool all_same_bits(std::vector<double> const &a, std::vector<double> const &b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_bits);
}

} // namespace symreal
