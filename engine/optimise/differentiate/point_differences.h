// Directional differences of a graph at one point, in extended precision, extrapolated to a step of 0.
#pragma once

#include "engine/graph/extended.h"

#include <optional>
#include <span>
#include <vector>

namespace symreal {

// A derivative if the differences are sharp; nullopt at a kink, jump or pole, or if rounding hides it.
using SharpNumber = std::optional<long double>;

class PointDifferences {
public:
  using Vector = std::vector<long double>;

  // Differences of `nodes`. Extended precision can evaluate `graph`; it and `parameters` outlive this object. A number
  // is sharp if its estimated error is within `tolerance` of the larger of its magnitude and 1.
  PointDifferences(Graph const &graph, std::vector<NodeId> const &nodes, std::span<double const> inputs,
                   std::span<double const> parameters, double tolerance, CallExternal const &call = {});

  // First or second derivatives of all nodes along a direction.
  std::vector<SharpNumber> along(Vector const &direction, int order) const;

  // Distance that an input moves for a visible change of the function.
  long double scale(std::uint32_t slot) const;
  std::size_t input_count() const { return inputs_.size(); }

  // Factor on the tolerance of second differences, which divide rounding by the square of the step.
  static constexpr double second = 100;

  // Number of graph evaluations per direction.
  static std::size_t const evaluations;

private:
  // Node values on both sides of the point; NaN if a branch decides differently there.
  struct Neighbours {
    long double step;
    Vector high, low;

    bool are_finite(std::size_t node) const;
  };
  // A difference quotient and the bound on its rounding error.
  struct Quotient {
    long double value, noise;
  };

  long double tolerance_of(int order) const { return order == 1 ? tolerance_ : second * tolerance_; }
  long double first_step(Vector const &direction) const;
  std::vector<Neighbours> neighbours_along(Vector const &direction) const;
  SharpNumber sharp(std::vector<Neighbours> const &neighbours, Vector const &noise, std::size_t node, int order) const;
  long double bend_of(Neighbours const &pair, std::size_t node) const;
  Quotient quotient(Neighbours const &pair, Vector const &noise, std::size_t node, int order) const;
  // Whether quotients at much smaller steps confirm a result; else the extrapolation's steps skipped features of the
  // function, such as whole periods of a sine.
  static bool is_confirmed(std::vector<Quotient> const &probes, long double result, long double last,
                           long double tolerance);
  Vector moved(Vector const &direction, long double step, std::uint64_t perturbation = 0) const;
  Vector noise_beside(Vector const &direction, Neighbours const &pair) const;

  Vector inputs_;
  long double tolerance_;
  ExtendedNeighbourhood neighbourhood_;
  Vector middle_; // node values at the point
};

} // namespace symreal
