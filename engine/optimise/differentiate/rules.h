// Derivative rules: of operations, a formula of the operation table per operand or the reason for its absence; and of
// calls of program functions whose derivatives the program provides, where each result depends on the numeric
// arguments.
#pragma once

#include "engine/graph/graph.h"
#include "engine/optimise/passes/term.h"

namespace symreal {

enum class Slope : std::uint8_t {
  formula,
  zero,   // a truth value, or the condition of a select
  steps,  // constant between jumps: a rounding, an integer, an element of a table
  unknown // a function without a rule in the table
};

// Slope of an operation by its operand `i`.
Slope slope_of(Op op, std::size_t i);
// Formula over the operands x, y, z and the result r.
Term const &derivative_of(Op op, std::size_t i);
// Whether the operation jumps although it has a formula between the jumps, as fmod does.
bool jumps_between(Op op);

// Appends the derivative functions of the called functions to the graph's externals, once each.
void add_derivative_functions(Graph &graph);
// Index of a function's derivative among the externals; their count if absent.
std::size_t derivative_function(Graph const &graph, std::size_t function);

// Numeric arguments of the call whose result is node `id`; empty if the function has no derivative.
std::vector<NodeId> differentiable_arguments(Graph const &graph, NodeId id);
// Index of the derivative call's result that is the partial of result `id` by the first numeric argument.
std::size_t first_partial(Graph const &graph, NodeId id);

} // namespace symreal
