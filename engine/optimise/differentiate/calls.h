// Calls of functions of the program whose derivatives the program has, too: each result depends on the numbers among
// the arguments.
#pragma once

#include "engine/graph/graph.h"

#include <vector>

namespace symreal {

// Puts the functions that give derivatives behind those that the graph calls, once each.
void add_derivative_functions(Graph &graph);
// The number of the derivative of a function; that of none, if there is none.
std::size_t derivative_function(Graph const &graph, std::size_t function);

// The numbers among the arguments of the call that node `id` is a result of, if its function has a derivative.
std::vector<NodeId> differentiable_arguments(Graph const &graph, NodeId id);
// By which result of the derivative's call the result `id` depends on the first of them.
std::size_t first_partial(Graph const &graph, NodeId id);

} // namespace symreal
