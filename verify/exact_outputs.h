// What the outputs of a graph would be if almost nothing were rounded: in numbers of as many bits as asked for.
#pragma once

#include "engine/graph/graph.h"
#include "verify/multiprecision.h"

#include <span>
#include <vector>

namespace symreal::program {

// Fewer than long double has would tell nothing new.
inline constexpr unsigned least_exact_bits = 65, most_exact_bits = 65536;

// One operation; those with integers as in double precision.
Multiprecision evaluate_exact(Op op, Multiprecision const &x, Multiprecision const &y, Multiprecision const &z);

// The graph has no obstacle (obstacle_to_extended).
class ExactOutputs {
public:
  ExactOutputs(Graph const &graph, unsigned bits);

  // At these inputs, where the nodes have `values` in double precision. False where a decision falls otherwise in more
  // bits, so that another formula would hold.
  bool move_to(std::span<double const> inputs, std::span<double const> parameters, std::span<double const> values);

  // How far a number is from this output there, relative to the larger of the output's magnitude and 1.
  double error_of(std::size_t slot, double number) const;

private:
  Graph const &graph_;
  std::vector<Multiprecision> outputs_;
};

} // namespace symreal::program
