// Numeric derivatives at one point in extended precision: each node of the recorded graph carries its value and slopes.
// Shares the rows of the operation table with differentiate.h, but neither the sweeps nor the expressions.
#pragma once

#include "engine/graph/evaluate.h"

#include <array>
#include <map>
#include <span>
#include <vector>

namespace symreal {

class PointDuals {
public:
  using Vector = std::vector<long double>;

  // Extended precision can evaluate `graph`, which outlives this object. `order` of the derivatives is 1 or 2.
  PointDuals(Graph const &graph, std::span<double const> inputs, std::span<double const> parameters, int order,
             CallExternal const &call = {});

  // Slopes of all outputs along a direction of the inputs.
  Vector forward(Vector const &direction) const;
  // Slopes of the weighted sum of the outputs by all inputs, and their change along a direction.
  Vector reverse(Vector const &weights) const;
  Vector second(Vector const &weights, Vector const &direction) const;

private:
  // Slopes of a differentiable call's result by the numeric arguments, and the change of these by each argument; the
  // latter is empty if the derivative has no derivative.
  struct CallSlopes {
    std::vector<NodeId> arguments;
    Vector first, second;
  };

  // Change of an operation's slopes by each operand.
  struct Curvature {
    NodeId node;
    std::array<std::array<long double, 3>, 3> by;
  };

  void add_curvature(NodeId id);
  Vector tangents(Vector const &direction) const;

  Graph const &graph_;
  Vector value_;                                  // per node
  std::vector<std::array<long double, 3>> slope_; // per node, by each operand
  std::vector<Curvature> curvatures_;             // of the nonlinear nodes, ascending
  std::map<NodeId, CallSlopes> call_slopes_;
};

} // namespace symreal
