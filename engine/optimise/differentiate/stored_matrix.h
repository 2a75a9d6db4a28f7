// Storage of a derivative matrix in the output array: dense, lower triangle, or nonzeros only.
#pragma once

#include "engine/optimise/differentiate/matrix.h"
#include "engine/optimise/differentiate/request.h"

#include <span>

namespace symreal {

struct StoredMatrix {
  DerivativeMatrix matrix; // without the output index
  std::vector<NodeId> results;
};

// Throws matrix_too_large.
StoredMatrix store(Graph &graph, DerivativeRequest const &request, MatrixElements elements);

// The whole matrix, row-major, from its stored elements.
std::vector<double> unpacked(DerivativeMatrix const &matrix, std::span<double const> stored);

} // namespace symreal
