// Source names for the nodes of a recorded graph.
#pragma once

#include "engine/graph/graph.h"
#include "rewrite/rewrite.h"

#include <vector>

namespace symreal::program {

// Names nodes: if a statement that names its value recorded several consecutive nodes, the last one is the value. The
// places of the graph must be resolved.
void name_nodes(Graph &graph, std::vector<rewrite::NamedStatement> const &statements);

} // namespace symreal::program
