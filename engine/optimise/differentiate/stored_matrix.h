// How a matrix of derivatives lies in the array of outputs: all of it, its lower half, or what is not zero.
#pragma once

#include "engine/optimise/differentiate/matrix.h"
#include "engine/optimise/differentiate/request.h"

#include <span>

namespace symreal {

struct StoredMatrix {
  DerivativeMatrix matrix; // but for the number of the output
  std::vector<NodeId> results;
};

// Throws matrix_too_large.
StoredMatrix store(Graph &graph, DerivativeRequest const &request, MatrixElements elements);

// The whole matrix, row by row, of what is stored.
std::vector<double> unpacked(DerivativeMatrix const &matrix, std::span<double const> stored);

} // namespace symreal
