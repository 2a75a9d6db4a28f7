// Keeping part of a graph.
#pragma once

#include "graph/graph.h"

namespace symreal {

// The graph without the nodes that are not kept. What a kept node or a root needs must be kept.
Graph compact(Graph const &graph, std::vector<char> const &keep);

} // namespace symreal
