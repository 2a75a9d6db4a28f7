// Which nodes carry a derivative from inputs to outputs, and where it is cut.
#pragma once

#include "engine/graph/graph.h"

#include <span>

namespace symreal {

struct DerivativePath {
  std::vector<char> carries;   // per node: the outputs depend on it, and it on the inputs, by formulas all the way
  std::vector<NodeId> jumps;   // operations on the way that are constant between jumps, or jump between formulas
  std::vector<NodeId> unknown; // operations on the way that have no derivative
};

// `inputs`: slots. Iterative, linear.
DerivativePath find_path(Graph const &graph, std::span<NodeId const> outputs, std::span<std::uint32_t const> inputs);

} // namespace symreal
