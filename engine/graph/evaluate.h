// The meaning of a graph: the value of every node at given inputs and parameters.
#pragma once

#include "engine/graph/graph.h"
#include "engine/ops/floating_point.h"

#include <cstdint>
#include <functional>
#include <span>

namespace symreal {

// Calls an external function, named by its number: arguments and results as in External.
using CallExternal =
    std::function<void(std::size_t function, std::span<double const> arguments, std::span<double> results)>;

// What becomes of each number that is computed: nothing, or it is rounded to single precision, to the nearest or to one
// side.
enum class Rounding : std::uint8_t { none, to_single, up_to_single, down_to_single };
double rounded(double value, Rounding rounding);

// Whether it calls functions of the program, which are not here. Those of complex numbers are.
bool calls_program(Graph const &graph);

// One value per node, by the reference semantics of the operation table; what is no number has the value 0. Calls are
// made in the order of the nodes; a graph that has some needs `call`, unless all are of functions of complex numbers.
// Linear, no recursion.
std::vector<double> evaluate(Graph const &graph, std::span<double const> inputs, std::span<double const> parameters,
                             CallExternal const &call = {}, Rounding rounding = Rounding::none);

// The first guard whose condition is 0; the number of guards where all hold.
std::size_t first_failing_guard(Graph const &graph, std::span<double const> values);

// The nodes that the program computes where the others have these values: what the guards need, up to the first that
// fails, and the results if none does. Of a select that is the arm taken, of && and || the second operand only where
// the first does not settle it. Iterative, linear.
std::vector<char> active_nodes(Graph const &graph, std::span<double const> values);

// Whether a sample lies where `finite` mode promises equality: (P1) every active value is finite, but for infinities
// that are constants of the program and only compared with and handed on, (P2) no zero reaches an operation that sees
// its sign.
struct Premises {
  bool finite = true;           // P1
  bool zero_sign_unseen = true; // P2
  // In every mode: indices lie in their tables, and integers in their types. Elsewhere the original has no meaning.
  bool defined = true;
  bool hold() const { return finite && zero_sign_unseen && defined; }
  // `strict` promises equality wherever the original has a meaning.
  bool hold_in(FloatingPoint mode) const { return mode == FloatingPoint::strict ? defined : hold(); }
};
Premises check_premises(Graph const &graph, std::span<double const> values);

// What verification asks of a graph at a sample.
struct Evaluation {
  std::vector<double> outputs;
  Premises premises;
  std::size_t failing_guard; // or the number of guards
};
Evaluation evaluate_sample(Graph const &graph, std::span<double const> inputs, std::span<double const> parameters,
                           CallExternal const &call = {}, Rounding rounding = Rounding::none);
// The same of values that are there.
Evaluation evaluation_of(Graph const &graph, std::span<double const> values);

} // namespace symreal
