// Validation of graph invariants, for every graph that is read and after every pass.
#pragma once

#include "engine/graph/graph.h"

namespace symreal {

// Whether the range is nonempty.
bool is_range(Range const &range);

// Reason why C cannot declare the function: an invalid identifier, an integer type unknown to C, or a function of
// <math.h> with another signature. Empty if it can.
std::string find_violation(External const &external);

// Description of the first violated invariant, or empty. `node` is set to the violating node, if it is a node's.
std::string find_violation(Graph const &graph, NodeId *node = nullptr);

} // namespace symreal
