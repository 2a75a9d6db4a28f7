// Operands for table-driven tests: drawn from an operation's domain, with corners, always the same.
#pragma once

#include "ops/operation.h"

#include <array>
#include <random>
#include <vector>

namespace symreal::test {

inline double sample(Domain domain, std::mt19937_64 &random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  double x = uniform(random);
  switch (domain) {
  case Domain::any: return 5 * x;
  case Domain::positive: return 0.1 + 4 * std::abs(x);
  case Domain::unit: return 0.95 * x;
  case Domain::above_one: return 1.1 + 4 * std::abs(x);
  }
  return x;
}

inline std::vector<std::array<double, 3>> samples(OperationInfo const &operation, int count) {
  std::mt19937_64 random(20131);
  std::vector<std::array<double, 3>> result;
  for (int k = 0; k < count; ++k) {
    std::array<double, 3> operands{};
    for (double &operand : operands) operand = sample(operation.domain, random);
    if (operation.op == Op::select || operation.has(flag::LOGICAL)) // operands that are truth values
      for (std::size_t i = 0; i < (operation.op == Op::select ? 1u : 3u); ++i) operands[i] = operands[i] > 0;
    result.push_back(operands);
  }
  return result;
}

} // namespace symreal::test
