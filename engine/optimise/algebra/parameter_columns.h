// What multiplies each parameter in the values that are linear in parameters.
#pragma once

#include "engine/optimise/algebra/network.h"

#include <cstdint>
#include <vector>

namespace symreal::algebra {

// The parameters, and the values that are sums of products with them. Parameters are here all that is made of them and
// of numbers alone, but for sums and multiples, which are made of others.
class ParameterColumns {
public:
  explicit ParameterColumns(Network const &network);

  std::vector<Index> const &parameters() const { return parameters_; }
  bool is_parameter(Index node) const { return column_[node] != no_index; }
  // Free, and a sum of multiples of parameters.
  bool is_sum(Index node) const { return is_linear_[node] && network_[node].is_free() && !is_parameter(node); }
  // How much work it is to make the rows of one point.
  std::uint64_t work() const { return (sums_.size() + 1) * network_.size(); }

  // At a random point, by its number: per value one number per parameter. Modulo the prime, and in extended precision.
  void make_rows(std::uint64_t point);
  std::vector<std::vector<Residue>> const &residues() const { return residues_; }
  std::vector<std::vector<long double>> const &numbers() const { return numbers_; }

private:
  void classify(Index node);
  void add_sum(Literal literal);
  void evaluate(std::uint64_t point);

  Network const &network_;
  std::vector<Index> column_;   // per node: which parameter it is, or no_index
  std::vector<char> is_linear_; // per node: in parameters
  std::vector<char> is_used_;   // per node: as a whole, by what is not linear
  std::vector<Index> parameters_, sums_;
  std::vector<Residue> residue_;    // per node
  std::vector<long double> number_; // per node
  std::vector<std::vector<Residue>> residues_;
  std::vector<std::vector<long double>> numbers_;
};

} // namespace symreal::algebra
