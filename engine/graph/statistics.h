// Operation counts, as reports and tests state them.
#pragma once

#include "engine/graph/graph.h"

namespace symreal {

// `recorded`: the distinct operations of the graph, live or not. `compute` and `preprocess`: the live ones, by where
// they run. What the program executed while it was recorded stands in the graph (`executed`).
struct Statistics {
  OperationCounts recorded, compute, preprocess;
};
Statistics statistics(Graph const &graph);

// Those that some root needs.
OperationCounts live_operations(Graph const &graph);

// Per location of the graph: the operations that come from there, all or those that some root needs.
std::vector<std::size_t> operations_by_location(Graph const &graph, bool live_only);

} // namespace symreal
