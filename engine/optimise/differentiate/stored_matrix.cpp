#include "engine/optimise/differentiate/stored_matrix.h"

#include <algorithm>

namespace symreal {

namespace {

constexpr std::size_t most_elements = std::size_t{1} << 20; // each appears in the generated code

// Stores each element, zeros included, of the whole matrix or its lower triangle.
void store_all(MatrixElements const &elements, NodeId zero, StoredMatrix &stored) {
  DerivativeMatrix &matrix = stored.matrix;
  auto next = elements.begin();
  for (std::uint32_t i = 0; i < matrix.rows; ++i)
    for (std::uint32_t j = 0; j < (matrix.is_symmetric ? i + 1 : matrix.columns); ++j) {
      bool const is_there = next != elements.end() && next->row == i && next->column == j;
      stored.results.push_back(is_there ? next->node : zero);
      if (is_there || matrix.is_symmetric) matrix.row.push_back(i), matrix.column.push_back(j);
      next += is_there;
    }
}

void store_nonzeros(MatrixElements const &elements, StoredMatrix &stored) {
  for (auto const &[row, column, node] : elements) {
    stored.results.push_back(node);
    stored.matrix.row.push_back(row), stored.matrix.column.push_back(column);
  }
}

} // namespace

StoredMatrix store(Graph &graph, DerivativeRequest const &request, MatrixElements elements) {
  std::vector<std::size_t> const extents = request.extents();
  StoredMatrix stored{{0, static_cast<std::uint32_t>(extents[0]), static_cast<std::uint32_t>(extents[1]),
                       request.is_packed(), request.is_symmetric},
                      {}};
  if (request.is_symmetric)
    std::erase_if(elements, [](MatrixElement const &element) { return element.column > element.row; });
  std::size_t const whole = request.is_symmetric ? extents[0] * (extents[0] + 1) / 2 : extents[0] * extents[1];
  std::size_t const count = request.is_sparse ? elements.size() : whole;
  if (count > most_elements)
    fail(DiagnosticId::matrix_too_large, request.place,
         request.name + " would store " + std::to_string(count) +
             (request.is_sparse ? " numbers that are not zero by structure" : " numbers") + "; the most are " +
             std::to_string(most_elements));
  if (request.is_sparse) {
    store_nonzeros(elements, stored);
  } else {
    Expressions expressions(graph);
    NodeId const zero = expressions.constant(0);
    expressions.finish();
    store_all(elements, zero, stored);
  }
  return stored;
}

std::vector<double> unpacked(DerivativeMatrix const &matrix, std::span<double const> stored) {
  if (!matrix.is_packed) return {stored.begin(), stored.end()};
  std::vector<double> whole(std::size_t{matrix.rows} * matrix.columns, 0);
  for (std::size_t k = 0; k < stored.size(); ++k) {
    whole[std::size_t{matrix.row[k]} * matrix.columns + matrix.column[k]] = stored[k];
    if (matrix.is_symmetric) whole[std::size_t{matrix.column[k]} * matrix.columns + matrix.row[k]] = stored[k];
  }
  return whole;
}

} // namespace symreal
