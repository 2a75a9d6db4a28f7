// What derivatives are by dual numbers over the recorded graph.
#pragma once

#include "engine/optimise/differentiate/point_duals.h"
#include "engine/optimise/differentiate/request.h"
#include "engine/optimise/differentiate/structure.h"

#include <span>
#include <vector>

namespace symreal {

class DualNumbers {
public:
  using Vector = PointDuals::Vector;

  // `graph` outlives this. One that calls functions has got those that give their derivatives, by
  // add_derivative_functions.
  DualNumbers(Graph const &graph, std::vector<DerivativeRequest> requests, CallExternal call = {});

  // How many passes over the graph one sample needs.
  std::size_t passes() const;

  // As Differences::at, at every point: what a kink or a pole has there the table says. `seeds`: of each request.
  Vector at(std::span<std::span<double const> const> seeds, std::span<double const> inputs,
            std::span<double const> parameters) const;

private:
  // How the elements of a matrix are found: those that are not zero by structure. Indices are those of the request.
  struct Plan {
    Pattern rows;
    Colouring colours;           // of columns
    std::vector<char> is_direct; // per row, of a Hessian per row and column: by a pass of its own
  };

  Plan plan_of(DerivativeRequest const &request) const;
  // With a pass for each row, or column, whatever is zero by structure.
  static Plan without_structure(DerivativeRequest const &request);
  Vector jacobian(PointDuals const &point, DerivativeRequest const &request, Plan const &plan) const;
  Vector hessian(PointDuals const &point, DerivativeRequest const &request, Plan const &plan,
                 Vector const &weights) const;
  // Whether a matrix times a direction is what the direction gives at once: what has been taken for zero is zero.
  bool is_whole(PointDuals const &point, DerivativeRequest const &request, Vector const &matrix,
                Vector const &weights) const;
  Vector matrix_of(PointDuals const &point, DerivativeRequest const &request, Plan const &plan,
                   Vector const &weights) const;

  Graph const &graph_;
  std::vector<DerivativeRequest> requests_;
  CallExternal call_;
  std::vector<Plan> plans_; // empty ones of requests that are no matrices
};

} // namespace symreal
