// Derivatives at one point as numbers, in extended precision: each node carries its value and its slopes, over the
// graph as it was recorded. Of what differentiate.h is made of this shares the rows of the table, and neither the
// sweeps nor the expressions.
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

  // Extended precision can evaluate `graph`, which outlives this. `order`: of the derivatives, 1 or 2.
  PointDuals(Graph const &graph, std::span<double const> inputs, std::span<double const> parameters, int order,
             CallExternal const &call = {});

  // The slopes of all outputs along a direction of the inputs.
  Vector forward(Vector const &direction) const;
  // The slopes by all inputs of the weighted sum of the outputs, and how these change along a direction.
  Vector reverse(Vector const &weights) const;
  Vector second(Vector const &weights, Vector const &direction) const;

private:
  // Of a result of a call whose function has a derivative: its slopes by the numbers among the arguments, and how these
  // change by each, where the derivative has a derivative.
  struct CallSlopes {
    std::vector<NodeId> arguments;
    Vector first, second;
  };

  // How the slopes of an operation change by each operand.
  struct Curvature {
    NodeId node;
    std::array<std::array<long double, 3>, 3> by;
  };

  void add_curvature(NodeId id);
  Vector tangents(Vector const &direction) const;

  Graph const &graph_;
  Vector value_;                                  // per node
  std::vector<std::array<long double, 3>> slope_; // by each operand
  std::vector<Curvature> curvatures_;             // of those that have one, ascending
  std::map<NodeId, CallSlopes> call_slopes_;
};

} // namespace symreal
