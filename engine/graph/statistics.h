// Operation counts of a graph for reports and tests.
#pragma once

#include "engine/graph/graph.h"

namespace symreal {

// `recorded`: the distinct operations of the graph, live or dead. `compute` and `preprocess`: the live ones of each
// function. The graph itself has the counts of the recorded run (`executed`).
struct Statistics {
  OperationCounts recorded, compute, preprocess;
};
Statistics statistics(Graph const &graph);

// Operations that a root needs.
OperationCounts live_operations(Graph const &graph);

// Operation count per location of the graph, of all or only of live operations.
std::vector<std::size_t> operations_by_location(Graph const &graph, bool live_only);

} // namespace symreal
