// What derivatives are without the rules that make them: central differences of the recorded graph in extended
// precision, extrapolated to a step of 0. Shares nothing with differentiate.h but the reading of a request. Inputs of
// which no addend of an output has two are moved at the same time.
#pragma once

#include "engine/graph/graph.h"
#include "engine/optimise/differentiate/addends.h"
#include "engine/optimise/differentiate/point_differences.h"
#include "engine/optimise/differentiate/request.h"

#include <span>
#include <vector>

namespace symreal {

class Differences {
public:
  // `graph` is as recorded, without derivatives, and outlives this.
  // `call`: the program's functions, if it calls some.
  Differences(Graph const &graph, std::span<DerivativeWish const> wishes, CallExternal call = {});

  // Why there are none, in words; empty where there are.
  std::string const &obstacle() const { return obstacle_; }
  // How many evaluations of the graph one sample needs.
  std::size_t evaluations() const;
  // How many inputs differentiation adds.
  std::size_t seed_count() const { return seed_count_; }
  std::vector<DerivativeRequest> const &requests() const { return requests_; }
  // Those of each request, of all that are added.
  std::vector<std::span<double const>> seeds_of_requests(std::span<double const> seeds) const;

  // What is requested, in order, and matrices as wholes. `inputs` are those of the graph, then the seeds. An element is
  // sharp if its error is estimated to be within `tolerance`, in Hessians PointDifferences::second times that, of the
  // larger of its magnitude and 1.
  std::vector<SharpNumber> at(std::span<double const> inputs, std::span<double const> parameters,
                              double tolerance) const;

private:
  // Outputs that are differentiated in the same directions.
  struct Directions {
    Addends addends;
    Colouring colours;                                          // of input slots
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs; // of colours, for second derivatives
    Pattern input_of;                                           // of each term the input of a colour; or none
  };
  using SharpVector = std::vector<SharpNumber>;
  using Kinds = std::initializer_list<DerivativeKind>;

  std::optional<Directions> directions_of(Kinds kinds) const;
  PointDifferences point_of(Directions const &directions, std::span<double const> inputs,
                            std::span<double const> parameters, double tolerance) const;
  // Of a request in the matrix of first derivatives of the terms, by colours.
  SharpNumber element(Directions const &directions, std::vector<SharpVector> const &columns, std::uint32_t output,
                      std::uint32_t input) const;
  void add_first(DerivativeRequest const &request, std::vector<SharpVector> const &columns,
                 std::span<double const> weights, SharpVector &result) const;
  std::vector<SharpVector> hessians(std::span<double const> inputs, std::span<double const> parameters,
                                    std::span<std::span<double const> const> seeds, double tolerance) const;

  Graph const &graph_;
  CallExternal call_;
  std::vector<DerivativeRequest> requests_;
  std::vector<std::size_t> first_seed_; // of each, among the inputs that are added
  std::size_t seed_count_ = 0;
  std::string obstacle_;
  std::optional<Directions> first_, second_, given_; // of gradients, Hessians, and products with a direction
};

} // namespace symreal
