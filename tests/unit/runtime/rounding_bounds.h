// The values of a graph without rounding, nearly, and a bound on the error of computing each in double precision: how
// much its operands' errors move it, and its own rounding. So what is ill-conditioned has a large bound by itself.
#pragma once

#include "engine/graph/extended.h"
#include "engine/graph/graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace symreal::test {

struct Bounded {
  long double value = 0; // in extended precision
  long double error = 0; // infinite where nothing can be said
};

// To the first order, but that the corners of what the operands may be are tried, so that a pole, a jump or a decision
// among them shows.
inline Bounded bounded(Op op, std::span<Bounded const> operands) {
  constexpr long double infinite = std::numeric_limits<long double>::infinity();
  constexpr long double unit = 0x1p-52L, least = 0x1p-1000L, largest = 0x1p1000L;
  bool const is_linear = op == Op::add || op == Op::sub || op == Op::mul || op == Op::neg || op == Op::abs;
  long double v[3] = {};
  for (std::size_t k = 0; k < operands.size(); ++k) v[k] = operands[k].value;
  Bounded result{evaluate_extended(op, v[0], v[1], v[2]), 0};
  for (std::size_t k = 0; k < operands.size(); ++k) {
    bool const may_be_any = op == Op::select && k > 0; // an arm that is not taken
    if (!may_be_any && !(operands[k].error <= (is_linear ? largest : 0.01L))) return {result.value, infinite};
  }
  for (unsigned corner = 0; corner < 1u << operands.size(); ++corner) {
    long double at[3] = {};
    for (std::size_t k = 0; k < operands.size(); ++k) at[k] = v[k] + (corner >> k & 1 ? -1 : 1) * operands[k].error;
    long double const moved = std::fabs(evaluate_extended(op, at[0], at[1], at[2]) - result.value);
    result.error = moved <= result.error ? result.error : moved; // NaN as well
  }
  if (!(result.error <= largest) || !(std::fabs(result.value) <= largest)) return {result.value, infinite};
  bool const is_choice = op == Op::select || info(op).has(flag::BOOLEAN);
  if (!is_choice) result.error += 4 * unit * std::fabs(result.value) + least;
  return result;
}

// Per node. A number of the graph may be the rounding of an exact one.
inline std::vector<Bounded> rounding_bounds(Graph const &graph, std::span<double const> inputs,
                                            std::span<double const> parameters) {
  constexpr long double unit = 0x1p-52L;
  std::vector<Bounded> all;
  for (Node const &node : graph.nodes) {
    switch (node.op) {
    case Op::constant: all.push_back({node.value(), unit * std::fabs(node.value())}); break;
    case Op::input: all.push_back({inputs[node.slot()], 0}); break;
    case Op::parameter: all.push_back({parameters[node.slot()], 0}); break;
    default: {
      Bounded operands[3];
      for (std::size_t k = 0; k < arity(node.op); ++k) operands[k] = all[node.operand[k]];
      all.push_back(bounded(node.op, {operands, arity(node.op)}));
    }
    }
  }
  return all;
}

} // namespace symreal::test
