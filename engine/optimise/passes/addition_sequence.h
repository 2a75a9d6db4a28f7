// Addition chains for several targets: the exponents of x when multiplications make its powers.
#pragma once

#include <vector>

namespace symreal {

struct Addition {
  int sum, a, b; // sum = a + b; each operand is given or an earlier sum
};

// Shortest sequence of additions from `given` to all of `wanted`; the binary method's if the search exceeds its budget.
// All numbers are positive multiples of the least given one, whether or not `wanted` has it.
std::vector<Addition> addition_sequence(std::vector<int> given, std::vector<int> wanted);

} // namespace symreal
