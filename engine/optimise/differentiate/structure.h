// Structural sparsity of derivatives: the inputs that a node depends on, and the pairs of inputs that it depends on
// nonlinearly. Shares only the operation table with differentiate.h.
#pragma once

#include "engine/graph/graph.h"

#include <span>
#include <vector>

namespace symreal {

// Columns of the structurally nonzero elements of each row, ascending.
using Pattern = std::vector<std::vector<std::uint32_t>>;

// Input slots that each node depends on in any way.
Pattern inputs_of(Graph const &graph, std::span<NodeId const> nodes);

// Sparsity of the Hessian of the nodes together: per input slot, its partners in a second derivative. Symmetric.
Pattern coupled_inputs(Graph const &graph, std::span<NodeId const> nodes);

// Column colouring (Curtis, Powell and Reid): columns of one colour share no row, so the sum of a colour's columns
// shows each of their elements.
struct Colouring {
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::vector<std::uint32_t> colour; // per column; `none` for an empty column
  std::size_t count = 0;
};
Colouring coloured(Pattern const &rows, std::size_t columns);

} // namespace symreal
