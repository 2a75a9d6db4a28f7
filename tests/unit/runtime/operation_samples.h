// Operands for table-driven tests: drawn from an operation's domain, with corners, always the same.
#pragma once

#include "engine/ops/operation.h"

#include <array>
#include <cmath>
#include <random>
#include <string>
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
  case Domain::integer: return std::trunc(std::ldexp(x, static_cast<int>(random() % 63)));
  }
  return x;
}

inline std::vector<std::array<double, 3>> samples(OperationInfo const &operation, int count) {
  std::mt19937_64 random(20131);
  std::vector<std::array<double, 3>> result;
  for (int k = 0; k < count; ++k) {
    std::array<double, 3> operands{};
    for (double &operand : operands) operand = sample(operation.domain, random);
    bool const selects = operation.form == Form::select;
    if (selects || operation.has(flag::LOGICAL)) // operands that are truth values
      for (std::size_t i = 0; i < (selects ? 1u : 3u); ++i) operands[i] = operands[i] > 0;
    result.push_back(operands);
  }
  return result;
}

// The operation as a function of numbers, which is how graphs of a single one are written: its integers of 64 bits are
// conversions of numbers, and its result becomes one.
inline double on_numbers(OperationInfo const &operation, std::array<double, 3> operands) {
  for (unsigned i = 0; i < operation.arity; ++i)
    if (takes_wide(operation.op, i)) operands[i] = evaluate(Op::wide_int, operands[i], 0, 0);
  double const result = evaluate(operation.op, operands[0], operands[1], operands[2]);
  return operation.has(flag::WIDE) ? evaluate(Op::wide_value, result, 0, 0) : result;
}

// Lines of a graph's text for it, on nodes %first and those behind it, from node %next on; the last is the result.
inline std::string lines_on_numbers(OperationInfo const &operation, std::size_t first, std::size_t &next) {
  std::string lines, operands;
  for (unsigned i = 0; i < operation.arity; ++i) {
    std::size_t operand = first + i;
    if (takes_wide(operation.op, i)) {
      lines += "%" + std::to_string(next) + " = wide_int %" + std::to_string(operand) + "\n";
      operand = next++;
    }
    operands += " %" + std::to_string(operand);
  }
  lines += "%" + std::to_string(next++) + " = " + std::string(operation.name) + operands + "\n";
  if (operation.has(flag::WIDE)) {
    lines += "%" + std::to_string(next) + " = wide_value %" + std::to_string(next - 1) + "\n";
    ++next;
  }
  return lines;
}

} // namespace symreal::test
