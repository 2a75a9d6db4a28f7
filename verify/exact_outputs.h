// Outputs of a graph evaluated in multiprecision, with as many bits as asked for.
#pragma once

#include "engine/graph/graph.h"
#include "verify/multiprecision.h"

#include <span>
#include <vector>

namespace symreal::program {

// Range of precisions; the least exceeds that of long double.
inline constexpr unsigned least_exact_bits = 65, most_exact_bits = 65536;

// Evaluates one operation; operations on integers as in double precision.
Multiprecision evaluate_exact(Op op, Multiprecision const &x, Multiprecision const &y, Multiprecision const &z);

// Multiprecision evaluator of a graph without obstacles (obstacle_to_extended).
class ExactOutputs {
public:
  ExactOutputs(Graph const &graph, unsigned bits);

  // Evaluates at these inputs, where the nodes have `values` in double precision. False if a decision differs in more
  // bits, so that another formula would hold.
  bool move_to(std::span<double const> inputs, std::span<double const> parameters, std::span<double const> values);

  // Error of a number against this output, relative to max(|output|, 1).
  double error_of(std::size_t slot, double number) const;

private:
  Graph const &graph_;
  std::vector<Multiprecision> outputs_;
};

} // namespace symreal::program
