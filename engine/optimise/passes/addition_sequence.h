// Which sums lead to given numbers: the exponents of x when powers are made by multiplications.
#pragma once

#include <vector>

namespace symreal {

struct Addition {
  int sum, a, b; // sum = a + b, which are given or earlier sums
};

// The fewest additions from `given` to all of `wanted`, or, where these are too many for a search, those of the binary
// method. All numbers are positive and multiples of the least given one, which is in `wanted` or not.
std::vector<Addition> addition_sequence(std::vector<int> given, std::vector<int> wanted);

} // namespace symreal
