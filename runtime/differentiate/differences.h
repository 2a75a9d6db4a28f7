// What derivatives are without the rules that make them: central differences of the recorded graph in extended
// precision, extrapolated to a step of 0. Shares nothing with differentiate.h but the reading of a request.
#pragma once

#include "differentiate/point_differences.h"
#include "differentiate/request.h"
#include "graph/graph.h"

#include <span>
#include <vector>

namespace symreal {

class Differences {
public:
  // `graph` is as recorded, without derivatives, and outlives this.
  Differences(Graph const &graph, std::span<DerivativeWish const> wishes);

  // Why there are none, in words; empty where there are.
  std::string const &obstacle() const { return obstacle_; }
  // How many evaluations of the graph one sample needs.
  std::size_t evaluations() const;
  // How many inputs and outputs differentiation adds.
  std::size_t seed_count() const;
  std::size_t output_count() const;

  // The outputs that differentiation adds, in order. `inputs` are those of the graph, then the seeds. An element is
  // sharp if its error is estimated to be within `tolerance` of the larger of its magnitude and 1.
  std::vector<SharpNumber> at(std::span<double const> inputs, std::span<double const> parameters,
                              double tolerance) const;

private:
  Graph const &graph_;
  std::vector<DerivativeRequest> requests_;
  std::string obstacle_;
};

} // namespace symreal
