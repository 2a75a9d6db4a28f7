// Values of a long function that wait for nobody are computed where they are first read.
#pragma once

#include "engine/plan/schedule/schedule.h"

namespace symreal {

// A statement moves down to the first that reads it, if what it reads itself lives that long anyway: then fewer values
// live at any point, and fewer cross from chunk to chunk. Statements in blocks and what conditions read stay.
// `is_read`: nodes that are found in an array. Linear.
void delay(Graph const &graph, std::vector<char> const &is_read, std::vector<NodeId> const &conditions,
           FunctionBody &body);

} // namespace symreal
