// Sinking of statements: values of a long function are computed just before their first reader.
#pragma once

#include "engine/plan/schedule/schedule.h"

namespace symreal {

// Moves a statement down to its first reader if the operands live that long anyway: then fewer values are live at any
// point, and fewer cross chunks. Statements in blocks and those that conditions read stay. `is_read`: nodes that are
// read from arrays. Linear time.
void delay(Graph const &graph, std::vector<char> const &is_read, std::vector<NodeId> const &conditions,
           FunctionBody &body);

} // namespace symreal
