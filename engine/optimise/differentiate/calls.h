// Differentiable calls: calls of program functions whose derivatives the program provides. Each result depends on the
// numeric arguments.
#pragma once

#include "engine/graph/graph.h"

#include <vector>

namespace symreal {

// Appends the derivative functions of the called functions to the graph's externals, once each.
void add_derivative_functions(Graph &graph);
// Index of a function's derivative among the externals; their count if absent.
std::size_t derivative_function(Graph const &graph, std::size_t function);

// Numeric arguments of the call whose result is node `id`; empty if the function has no derivative.
std::vector<NodeId> differentiable_arguments(Graph const &graph, NodeId id);
// Index of the derivative call's result that is the partial of result `id` by the first numeric argument.
std::size_t first_partial(Graph const &graph, NodeId id);

} // namespace symreal
