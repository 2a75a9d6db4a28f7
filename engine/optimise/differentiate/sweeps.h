// The two ways through a graph that the chain rule has. Each is linear in the nodes, for one direction or one output.
#pragma once

#include "engine/optimise/differentiate/expressions.h"

#include <span>

namespace symreal {

// Forward: the derivatives of `outputs` along a direction, whose element for the input slot s is direction[s]: a node,
// or no_node for zero. `carries`: per node, as DerivativePath has it.
std::vector<NodeId> forward_sweep(Expressions &expressions, std::vector<char> const &carries,
                                  std::span<NodeId const> outputs, std::span<NodeId const> direction);

// Reverse: the derivatives by each input slot, of which there are `inputs`, of the sum of the outputs that is weighted
// with the nodes `weights`.
std::vector<NodeId> reverse_sweep(Expressions &expressions, std::vector<char> const &carries,
                                  std::span<NodeId const> outputs, std::span<NodeId const> weights, std::size_t inputs);

} // namespace symreal
