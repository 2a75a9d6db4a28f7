// Derivative matrices as lists of structurally nonzero elements.
#pragma once

#include "engine/optimise/differentiate/expressions.h"

#include <vector>

namespace symreal {

struct MatrixElement {
  std::uint32_t row, column;
  NodeId node;
};
using MatrixElements = std::vector<MatrixElement>; // row-major

enum class Way : std::uint8_t { forward, reverse };

// Jacobian of the nodes `rows` by the input slots `columns`.
MatrixElements jacobian_by(Way way, Graph &graph, std::vector<NodeId> const &rows,
                           std::vector<std::uint32_t> const &columns);

// Jacobian by the mode that costs less by the cost table. The lower triangle of a symmetric matrix is mirrored.
MatrixElements cheapest_jacobian(Graph &graph, std::vector<NodeId> const &rows,
                                 std::vector<std::uint32_t> const &columns, bool is_symmetric = false);

} // namespace symreal
