// Forward and reverse mode of the chain rule. A sweep is linear in the nodes, for one direction or one output.
#pragma once

#include "engine/optimise/differentiate/expressions.h"

#include <span>

namespace symreal {

// Forward mode: derivatives of `outputs` along `direction`, a node per input slot, no_node for zero. `carries` is that
// of DerivativePath.
std::vector<NodeId> forward_sweep(Expressions &expressions, std::vector<char> const &carries,
                                  std::span<NodeId const> outputs, std::span<NodeId const> direction);

// Reverse mode: derivatives, by each of the `inputs` input slots, of the sum of the outputs weighted with the nodes
// `weights`.
std::vector<NodeId> reverse_sweep(Expressions &expressions, std::vector<char> const &carries,
                                  std::span<NodeId const> outputs, std::span<NodeId const> weights, std::size_t inputs);

} // namespace symreal
