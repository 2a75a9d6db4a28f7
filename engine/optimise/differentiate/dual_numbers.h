// Reference derivatives by dual numbers over the recorded graph, in extended precision. Shares the rows of the
// operation table with differentiate.h, but neither the sweeps nor the expressions.
#pragma once

#include "engine/graph/evaluate.h"
#include "engine/optimise/differentiate/request.h"
#include "engine/optimise/differentiate/structure.h"

#include <span>
#include <vector>

namespace symreal {

class PointDuals;

class DualNumbers {
public:
  using Vector = std::vector<long double>;

  // `graph` outlives this object. If it calls functions, add_derivative_functions has appended their derivatives.
  DualNumbers(Graph const &graph, std::vector<DerivativeRequest> requests, CallExternal call = {});

  // Number of passes over the graph per sample.
  std::size_t passes() const;

  // As Differences::at, but also at kinks and poles, by the operation table. `seeds` are per request.
  Vector at(std::span<std::span<double const> const> seeds, std::span<double const> inputs,
            std::span<double const> parameters) const;

private:
  // Passes that compute the structurally nonzero elements of a matrix. Indices are relative to the request.
  struct Compression {
    Pattern rows;
    Colouring colours;           // of columns
    std::vector<char> is_direct; // per row (Hessian: row and column): computed by its own pass
  };

  Compression compression_of(DerivativeRequest const &request) const;
  // No compression: one pass per row or column, regardless of structural zeros.
  static Compression without_structure(DerivativeRequest const &request);
  Vector jacobian(PointDuals const &point, DerivativeRequest const &request, Compression const &compression) const;
  Vector hessian(PointDuals const &point, DerivativeRequest const &request, Compression const &compression,
                 Vector const &weights) const;
  // Checks the sparsity pattern: whether the matrix times a direction equals the directional derivative.
  bool is_whole(PointDuals const &point, DerivativeRequest const &request, Vector const &matrix,
                Vector const &weights) const;
  Vector matrix_of(PointDuals const &point, DerivativeRequest const &request, Compression const &compression,
                   Vector const &weights) const;

  Graph const &graph_;
  std::vector<DerivativeRequest> requests_;
  CallExternal call_;
  std::vector<Compression> compressions_; // empty for requests of other kinds
};

} // namespace symreal
