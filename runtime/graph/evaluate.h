// The meaning of a graph: the value of every node at given inputs and parameters.
#pragma once

#include "graph/graph.h"

#include <span>

namespace symreal {

// One value per node, by the reference semantics of the operation table. Linear, no recursion.
std::vector<double> evaluate(Graph const &graph, std::span<double const> inputs, std::span<double const> parameters);

// The first guard whose condition is 0; the number of guards where all hold.
std::size_t first_failing_guard(Graph const &graph, std::span<double const> values);

// The nodes that the program computes where the others have these values: what the guards need, up to the first that
// fails, and the results if none does. Of a select that is the arm taken, of && and || the second operand only where
// the first does not settle it. Iterative, linear.
std::vector<char> active_nodes(Graph const &graph, std::span<double const> values);

// Whether a sample lies where `finite` mode promises equality: (P1) every active value is finite, (P2) no zero reaches
// an operation that sees its sign.
struct Premises {
  bool finite = true;           // P1
  bool zero_sign_unseen = true; // P2
  bool hold() const { return finite && zero_sign_unseen; }
};
Premises check_premises(Graph const &graph, std::span<double const> values);

} // namespace symreal
