// A graph as a chain of parts: all tasks of a part must end before any of the next begins. So the parts can be
// scheduled one by one, and a shortest timetable of the graph is the shortest ones of its parts, one after the other.
#pragma once

#include "engine/analysis/scheduling/network.h"

namespace symreal {

// The tasks of each part, ascending. One part for very many tasks.
std::vector<std::vector<TaskId>> chain_of_parts(Network const &network);

// The tasks of a part with what they need of each other. Ids are places in `part`.
TaskGraph part_graph(TaskGraph const &graph, std::vector<TaskId> const &part);

} // namespace symreal
