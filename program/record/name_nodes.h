// Names from the source for the nodes of a recorded graph.
#pragma once

#include "engine/graph/graph.h"
#include "rewrite/rewrite.h"

#include <vector>

namespace symreal::program {

// Where a statement that names its value recorded several nodes in a row, the last of them is that value. The places of
// the graph must be resolved.
void name_nodes(Graph &graph, std::vector<rewrite::NamedStatement> const &statements);

} // namespace symreal::program
