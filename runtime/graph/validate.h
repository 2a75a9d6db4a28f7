// The invariants of a graph. Run on every graph that is read, and after every pass.
#pragma once

#include "graph/graph.h"

namespace symreal {

// The first violated invariant in words, or empty.
std::string find_violation(Graph const &graph);

} // namespace symreal
