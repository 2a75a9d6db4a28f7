// Evaluation of a graph in extended precision: its outputs almost without rounding errors.
#pragma once

#include "engine/graph/evaluate.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace symreal {

// Mantissa bits of the machine's widest type: 64 on x86-64.
inline constexpr int extended_bits = std::numeric_limits<long double>::digits;

// Reason why a graph has no extended evaluation: an operation on values other than real numbers. Empty if it has one.
// `calls`: whether pure functions of the program can be called.
std::string obstacle_to_extended(Graph const &graph, bool calls = false);

// Evaluates one operation; integer operations as in double precision.
long double evaluate_extended(Op op, long double x, long double y, long double z);

// One number per output slot. `values`: those of the nodes in double precision. Nullopt if a comparison or a conversion
// to integer differs in extended precision, which selects another formula. Requires a graph without obstacle. Calls
// take and return doubles.
std::optional<std::vector<long double>> evaluate_extended(Graph const &graph, std::span<double const> inputs,
                                                          std::span<double const> parameters,
                                                          std::span<double const> values,
                                                          CallExternal const &call = {});

// Values of nodes in extended precision, at many points near a base point.
class ExtendedNeighbourhood {
public:
  // `values`: those of all nodes in double precision at the base point. All but `call` and `values` must outlive this.
  ExtendedNeighbourhood(Graph const &graph, std::vector<NodeId> const &nodes, std::span<double const> parameters,
                        std::vector<double> values, CallExternal call = {});

  // One number per node of `nodes`; NaN if it depends on a choice that differs from the base point. A nonzero
  // `perturbation` moves every result by a unit in the last place (by a unit of a double for calls), which exposes
  // rounding errors: 1 moves up, other values give a pattern of directions.
  std::vector<long double> at(std::span<long double const> inputs, std::uint64_t perturbation = 0) const;

private:
  void spread(std::vector<char> &otherwise) const;

  Graph const &graph_;
  std::vector<NodeId> const &nodes_;
  std::span<double const> parameters_;
  std::vector<double> values_;
  CallExternal call_;
  std::vector<char> active_;
};

} // namespace symreal
