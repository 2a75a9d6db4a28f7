// Evaluation of a graph: the value of every node for given inputs and parameters.
#pragma once

#include "engine/graph/graph.h"
#include "engine/ops/floating_point.h"

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace symreal {

// Calls the external function of this number; arguments and results as in External.
using CallExternal =
    std::function<void(std::size_t function, std::span<double const> arguments, std::span<double> results)>;

// Results of the calls in a graph, each call evaluated once.
class CallResults {
public:
  // `graph` and `call` must outlive this object. `call` may be empty if the graph calls complex functions only.
  CallResults(Graph const &graph, CallExternal const &call) : graph_(graph), call_(call) {}

  // Results of function number `function` for the arguments of node `call`, whose values `value_of(node)` gives.
  template <class ValueOf> std::vector<double> &of(NodeId call, std::size_t function, ValueOf const &value_of) {
    auto const [found, is_new] = results_.try_emplace({call, function});
    if (is_new) found->second = results(call, function, value_of);
    return found->second;
  }

private:
  template <class ValueOf>
  std::vector<double> results(NodeId call, std::size_t function, ValueOf const &value_of) const {
    std::vector<double> arguments;
    for (NodeId const argument : arguments_of(graph_, graph_.nodes[call].operand[0]))
      arguments.push_back(value_of(argument));
    return called(function, arguments);
  }
  std::vector<double> called(std::size_t function, std::vector<double> const &arguments) const;

  Graph const &graph_;
  CallExternal const &call_;
  std::map<std::pair<NodeId, std::size_t>, std::vector<double>> results_;
};

// Rounding of each computed number: none, or to single precision, to nearest or in one direction.
enum class Rounding : std::uint8_t { none, to_single, up_to_single, down_to_single };
double rounded(double value, Rounding rounding);

// Whether the graph calls functions of the program, which only the program can execute; complex functions do not count.
bool calls_program(Graph const &graph);

// One value per node, by the reference semantics of the operation table; nodes that are not numbers have the value 0.
// Calls run in node order; a graph with calls needs `call`, unless all are complex functions. Linear time; iterative.
std::vector<double> evaluate(Graph const &graph, std::span<double const> inputs, std::span<double const> parameters,
                             CallExternal const &call = {}, Rounding rounding = Rounding::none);

// Index of the first guard whose condition is 0; the number of guards if all hold.
std::size_t first_failing_guard(Graph const &graph, std::span<double const> values);

// Nodes that the program computes for these values: those needed by the guards up to the first that fails, and by the
// results if all hold. A select needs the arm taken; && and || need the second operand only if the first leaves the
// value open. Iterative; linear time.
std::vector<char> active_nodes(Graph const &graph, std::span<double const> values);

// Premises under which `finite` mode promises equality for a sample: (P1) every active value is finite, except for
// infinite constants of the program that are only compared and passed on, (P2) no zero reaches an operation that sees
// its sign.
struct Premises {
  bool finite = true;           // P1
  bool zero_sign_unseen = true; // P2
  // In every mode: table indices are in range, and integers fit their types. Otherwise the original is undefined.
  bool defined = true;
  bool hold() const { return finite && zero_sign_unseen && defined; }
  // Mode `strict` promises equality wherever the original is defined.
  bool hold_in(FloatingPoint mode) const { return mode == FloatingPoint::strict ? defined : hold(); }
};
Premises check_premises(Graph const &graph, std::span<double const> values);

// Result of a graph at a sample, for verification.
struct Evaluation {
  std::vector<double> outputs;
  Premises premises;
  std::size_t failing_guard; // or the number of guards
};
Evaluation evaluate_sample(Graph const &graph, std::span<double const> inputs, std::span<double const> parameters,
                           CallExternal const &call = {}, Rounding rounding = Rounding::none);
// Likewise, from the values of all nodes.
Evaluation evaluation_of(Graph const &graph, std::span<double const> values);

} // namespace symreal
