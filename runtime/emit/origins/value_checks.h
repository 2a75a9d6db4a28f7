// The debug variant of generated code: the first value of a call that is not finite is reported with its source line.
#pragma once

#include "graph/graph.h"

#include <string>

namespace symreal {

// What stands before the functions.
std::string value_check_helper();
// At the beginning of preprocess and compute.
std::string value_check_begin();
// Behind the statement that sets `variable` to the value of a node.
std::string value_check(Graph const &graph, std::string const &variable, NodeId node);

} // namespace symreal
