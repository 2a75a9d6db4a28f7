// The meaning of a graph: the value of every node at given inputs and parameters.
#pragma once

#include "graph/graph.h"

#include <span>

namespace symreal {

// One value per node, by the reference semantics of the operation table. Linear, no recursion.
std::vector<double> evaluate(Graph const &graph, std::span<double const> inputs, std::span<double const> parameters);

// Whether a sample lies where `finite` mode promises equality: (P1) every live value is finite, (P2) no zero reaches an
// operation that sees its sign.
struct Premises {
  bool finite = true;           // P1
  bool zero_sign_unseen = true; // P2
  bool hold() const { return finite && zero_sign_unseen; }
};
Premises check_premises(Graph const &graph, std::span<double const> values);

} // namespace symreal
