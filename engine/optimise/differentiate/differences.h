// Reference derivatives without rules: central differences of the recorded graph in extended precision, extrapolated to
// a step of 0. Shares only the parsing of requests with differentiate.h. Inputs move together if no addend of an output
// depends on two of them.
#pragma once

#include "engine/graph/graph.h"
#include "engine/optimise/differentiate/point_differences.h"
#include "engine/optimise/differentiate/request.h"
#include "engine/optimise/differentiate/structure.h"

#include <span>
#include <vector>

namespace symreal {

class Differences {
public:
  // `graph` is the recorded graph, without derivatives, and outlives this object. `call` executes the program's
  // functions.
  Differences(Graph const &graph, std::span<DerivativeWish const> wishes, CallExternal call = {});

  // Reason why differences are unavailable; empty if they are available.
  std::string const &obstacle() const { return obstacle_; }
  // Number of graph evaluations per sample.
  std::size_t evaluations() const;
  // Number of inputs that differentiation adds.
  std::size_t seed_count() const { return seed_count_; }
  std::vector<DerivativeRequest> const &requests() const { return requests_; }
  // Slice of `seeds` that belongs to each request.
  std::vector<std::span<double const>> seeds_of_requests(std::span<double const> seeds) const;

  // Requested derivatives in order, matrices unpacked. `inputs` are those of the graph, then the seeds. An element is
  // sharp if its estimated error is within `tolerance` (in Hessians PointDifferences::second times that) of the larger
  // of its magnitude and 1.
  std::vector<SharpNumber> at(std::span<double const> inputs, std::span<double const> parameters,
                              double tolerance) const;

private:
  // Outputs that share their directions.
  struct Directions {
    Addends addends;
    Colouring colours;                                          // of input slots
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs; // of colours, for second derivatives
    Pattern input_of;                                           // [term][colour]: input slot, or Colouring::none
  };
  using SharpVector = std::vector<SharpNumber>;
  using Kinds = std::initializer_list<DerivativeKind>;

  std::optional<Directions> directions_of(Kinds kinds) const;
  PointDifferences point_of(Directions const &directions, std::span<double const> inputs,
                            std::span<double const> parameters, double tolerance) const;
  // Derivative of `output` by `input`, from the first derivatives of the terms by colour.
  SharpNumber element(Directions const &directions, std::vector<SharpVector> const &columns, std::uint32_t output,
                      std::uint32_t input) const;
  void add_first(DerivativeRequest const &request, std::vector<SharpVector> const &columns,
                 std::span<double const> weights, SharpVector &result) const;
  std::vector<SharpVector> hessians(std::span<double const> inputs, std::span<double const> parameters,
                                    std::span<std::span<double const> const> seeds, double tolerance) const;

  Graph const &graph_;
  CallExternal call_;
  std::vector<DerivativeRequest> requests_;
  std::vector<std::size_t> first_seed_; // per request, among the added inputs
  std::size_t seed_count_ = 0;
  std::string obstacle_;
  std::optional<Directions> first_, second_, given_; // first derivatives, Hessians, jvp
};

} // namespace symreal
