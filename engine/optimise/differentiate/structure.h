// What is zero by the structure of a graph: which inputs a node depends on, and which of these it is not linear in
// together. Shares nothing with differentiate.h but the table.
#pragma once

#include "engine/graph/graph.h"

#include <span>
#include <vector>

namespace symreal {

// The columns of each row that are not zero by structure, ascending.
using Pattern = std::vector<std::vector<std::uint32_t>>;

// The slots of the inputs that each node depends on, in whatever way.
Pattern inputs_of(Graph const &graph, std::span<NodeId const> nodes);

// The slots that stand with each input slot in a second derivative of one of the nodes: symmetric.
Pattern coupled_inputs(Graph const &graph, std::span<NodeId const> nodes);

// Columns of which no row has two have one colour (Curtis, Powell and Reid): the sum of all columns of a colour shows
// each of their elements.
struct Colouring {
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::vector<std::uint32_t> colour; // per column; none where no row has it
  std::size_t count = 0;
};
Colouring coloured(Pattern const &rows, std::size_t columns);

} // namespace symreal
