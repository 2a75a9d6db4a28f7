// Decomposition of a graph into a chain of parts: all tasks of a part must end before any of the next begins. So parts
// can be scheduled separately, and their shortest timetables concatenate to one of the graph.
#pragma once

#include "engine/analysis/scheduling/network.h"

namespace symreal {

// Tasks of each part, ascending. A single part for very many tasks.
std::vector<std::vector<TaskId>> chain_of_parts(Network const &network);

// Subgraph of a part, with its internal dependencies. Ids are indices into `part`.
TaskGraph part_graph(TaskGraph const &graph, std::vector<TaskId> const &part);

} // namespace symreal
