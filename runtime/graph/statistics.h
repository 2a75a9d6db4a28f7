// Operation counts, as reports and tests state them.
#pragma once

#include "graph/graph.h"

namespace symreal {

// `recorded`: the distinct operations of the graph, live or not. `compute` and `preprocess`: the live ones, by where
// they run. What the program executed while it was recorded stands in the graph (`executed`).
struct Statistics {
  OperationCounts recorded, compute, preprocess;
};
Statistics statistics(Graph const &graph);

} // namespace symreal
