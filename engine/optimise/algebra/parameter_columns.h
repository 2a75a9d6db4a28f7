// Parameter columns: coefficients of the parameters in values that are linear in them.
#pragma once

#include "engine/optimise/algebra/network.h"

#include <cstdint>
#include <vector>

namespace symreal::algebra {

// Parameters and the values linear in them. A parameter is any node computed from parameters and numbers alone, except
// sums and multiples of others.
class ParameterColumns {
public:
  explicit ParameterColumns(Network const &network);

  std::vector<Index> const &parameters() const { return parameters_; }
  bool is_parameter(Index node) const { return column_[node] != no_index; }
  // Whether the node is free and a linear combination of parameters.
  bool is_sum(Index node) const { return is_linear_[node] && network_[node].is_free() && !is_parameter(node); }
  // Cost of the rows of one point.
  std::uint64_t work() const { return (sums_.size() + 1) * network_.size(); }

  // Makes one row of coefficients per value at random point `point`, modulo the prime and in extended precision.
  void make_rows(std::uint64_t point);
  std::vector<std::vector<Residue>> const &residues() const { return residues_; }
  std::vector<std::vector<long double>> const &numbers() const { return numbers_; }

private:
  void classify(Index node);
  void add_sum(Literal literal);
  void evaluate(std::uint64_t point);

  Network const &network_;
  std::vector<Index> column_;   // per node: its parameter's number, or no_index
  std::vector<char> is_linear_; // per node: linear in parameters
  std::vector<char> is_used_;   // per node: used by a nonlinear node
  std::vector<Index> parameters_, sums_;
  std::vector<Residue> residue_;    // per node
  std::vector<long double> number_; // per node
  std::vector<std::vector<Residue>> residues_;
  std::vector<std::vector<long double>> numbers_;
};

} // namespace symreal::algebra
