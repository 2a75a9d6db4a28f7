// Derivative paths: the nodes that carry a derivative from inputs to outputs, and those that cut it.
#pragma once

#include "engine/graph/graph.h"

#include <span>

namespace symreal {

struct DerivativePath {
  std::vector<char> carries;   // per node: lies on a path from inputs to outputs whose steps all have formulas
  std::vector<NodeId> jumps;   // operations on the path that are piecewise constant, or jump between formulas
  std::vector<NodeId> unknown; // operations on the path without a derivative
};

// `inputs` are slots. Iterative, in linear time.
DerivativePath find_path(Graph const &graph, std::span<NodeId const> outputs, std::span<std::uint32_t const> inputs);

} // namespace symreal
