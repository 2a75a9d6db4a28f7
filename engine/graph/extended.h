// A graph in extended precision: what its outputs would be if almost nothing were rounded.
#pragma once

#include "engine/graph/evaluate.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace symreal {

// Of as many bits as the machine's widest numbers have: 64 on x86-64.
inline constexpr int extended_bits = std::numeric_limits<long double>::digits;

// Why a graph cannot be evaluated so, in words: an operation on something else than real numbers. Empty where it can.
// `calls`: pure functions of the program can be called.
std::string obstacle_to_extended(Graph const &graph, bool calls = false);

// One operation; those with integers as in double precision.
long double evaluate_extended(Op op, long double x, long double y, long double z);

// One number per output slot. `values` are those of the nodes in double precision: nothing where a comparison or a
// conversion to an integer gives something else in extended precision, so that another formula would hold. The graph
// has no obstacle. What it calls takes and gives doubles.
std::optional<std::vector<long double>> evaluate_extended(Graph const &graph, std::span<double const> inputs,
                                                          std::span<double const> parameters,
                                                          std::span<double const> values,
                                                          CallExternal const &call = {});

// Nodes of a graph in extended precision, at many points near one.
class ExtendedNeighbourhood {
public:
  // `values`: those of all nodes in double precision at that one. All but `call` and `values` outlive this.
  ExtendedNeighbourhood(Graph const &graph, std::vector<NodeId> const &nodes, std::span<double const> parameters,
                        std::vector<double> values, CallExternal call = {});

  // One number per node of `nodes`; not a number where one that it depends on makes another choice than at the one
  // point. With a `perturbation` other than 0 every result is moved by a unit in the last place, by 1 up, by others as
  // its number says: so rounding shows. Of a call that is a unit of a double.
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
