// Forward and reverse mode of the chain rule, the paths that they follow, and implicit solutions on these. A sweep is
// linear in the nodes, for one direction or one output.
#pragma once

#include "engine/optimise/differentiate/expressions.h"

#include <span>

namespace symreal {

// Derivative path: the nodes that carry a derivative from inputs to outputs, and those that cut it.
struct DerivativePath {
  std::vector<char> carries;   // per node: lies on a path from inputs to outputs whose steps all have formulas
  std::vector<NodeId> jumps;   // operations on the path that are piecewise constant, or jump between formulas
  std::vector<NodeId> unknown; // operations on the path without a derivative
};

// `inputs` are slots. Iterative, in linear time.
DerivativePath find_path(Graph const &graph, std::span<NodeId const> outputs, std::span<std::uint32_t const> inputs);

// Forward mode: derivatives of `outputs` along `direction`, a node per input slot, no_node for zero. `carries` is that
// of DerivativePath. Throws not_differentiable if a residual does not determine its solution.
std::vector<NodeId> forward_sweep(Expressions &expressions, std::vector<char> const &carries,
                                  std::span<NodeId const> outputs, std::span<NodeId const> direction);

// Reverse mode: derivatives, by each of the `inputs` input slots, of the sum of the outputs weighted with the nodes
// `weights`.
std::vector<NodeId> reverse_sweep(Expressions &expressions, std::vector<char> const &carries,
                                  std::span<NodeId const> outputs, std::span<NodeId const> weights, std::size_t inputs);

} // namespace symreal
