// Matrices of derivatives: those elements that are not zero by structure.
#pragma once

#include "engine/optimise/differentiate/expressions.h"

#include <vector>

namespace symreal {

struct MatrixElement {
  std::uint32_t row, column;
  NodeId node;
};
using MatrixElements = std::vector<MatrixElement>; // row by row

enum class Way : std::uint8_t { forward, reverse };

// Of nodes of `graph` by input slots.
MatrixElements jacobian_by(Way way, Graph &graph, std::vector<NodeId> const &rows,
                           std::vector<std::uint32_t> const &columns);

// Whichever way costs less by the table. Of a symmetric matrix what stands above the diagonal is what stands below.
MatrixElements cheapest_jacobian(Graph &graph, std::vector<NodeId> const &rows,
                                 std::vector<std::uint32_t> const &columns, bool is_symmetric = false);

} // namespace symreal
