// Differences of a graph at one point, along a direction, in extended precision: extrapolated to a step of 0.
#pragma once

#include "engine/graph/extended.h"

#include <optional>
#include <span>
#include <vector>

namespace symreal {

// A derivative, where the differences are sharp; else nothing: at a kink, a jump or a pole, or where rounding hides it.
using SharpNumber = std::optional<long double>;

class PointDifferences {
public:
  using Vector = std::vector<long double>;

  // Of `nodes` of `graph`, which extended precision can evaluate; both outlive this, as do the parameters. A number is
  // sharp if its error is estimated to be within `tolerance` of the larger of its magnitude and 1.
  PointDifferences(Graph const &graph, std::vector<NodeId> const &nodes, std::span<double const> inputs,
                   std::span<double const> parameters, double tolerance, CallExternal const &call = {});

  // The first or second derivative of all nodes along a direction.
  std::vector<SharpNumber> along(Vector const &direction, int order) const;

  // How far an input may move for the function to change visibly.
  long double scale(std::uint32_t slot) const;
  std::size_t input_count() const { return inputs_.size(); }

  // Second differences divide rounding by the square of the step: they are sharp within so many times the tolerance.
  static constexpr double second = 100;

  // How many evaluations of the graph a direction takes.
  static std::size_t const evaluations;

private:
  // The nodes on both sides of the point; not a number where a decision falls otherwise.
  struct Neighbours {
    long double step;
    Vector high, low;

    bool are_finite(std::size_t node) const;
  };
  // A difference quotient, and how far rounding may have moved it.
  struct Quotient {
    long double value, noise;
  };

  long double tolerance_of(int order) const { return order == 1 ? tolerance_ : second * tolerance_; }
  long double first_step(Vector const &direction) const;
  std::vector<Neighbours> neighbours_along(Vector const &direction) const;
  SharpNumber sharp(std::vector<Neighbours> const &neighbours, Vector const &noise, std::size_t node, int order) const;
  long double bend_of(Neighbours const &pair, std::size_t node) const;
  Quotient quotient(Neighbours const &pair, Vector const &noise, std::size_t node, int order) const;
  // Whether quotients at steps far below those of the extrapolation bear a result out: else these steps leapt over what
  // the function does, as over whole periods of a sine.
  static bool is_confirmed(std::vector<Quotient> const &probes, long double result, long double last,
                           long double tolerance);
  Vector moved(Vector const &direction, long double step, std::uint64_t perturbation = 0) const;
  Vector noise_beside(Vector const &direction, Neighbours const &pair) const;

  Vector inputs_;
  long double tolerance_;
  ExtendedNeighbourhood neighbourhood_;
  Vector middle_; // as high and low
};

} // namespace symreal
