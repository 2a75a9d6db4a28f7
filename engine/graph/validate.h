// The invariants of a graph. Run on every graph that is read, and after every pass.
#pragma once

#include "engine/graph/graph.h"

namespace symreal {

// Whether some number lies in it.
bool is_range(Range const &range);

// Whether C has it as a name: letters, digits and underscores, and no keyword of C.
bool is_c_identifier(std::string_view name);

// Why C cannot declare the function: a name that is no identifier, an integer of a type that C does not name so, a
// function of <math.h> that takes something else. Empty where it can.
std::string find_violation(External const &external);

// The first violated invariant in words, or empty. `node` becomes the node that violates it, where one does.
std::string find_violation(Graph const &graph, NodeId *node = nullptr);

} // namespace symreal
