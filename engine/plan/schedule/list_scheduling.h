// An order of statements that keeps the values that live at once in registers.
#pragma once

#include "engine/plan/schedule/schedule.h"

namespace symreal {

// List scheduling in two moods, after Goodman and Hsu, "Code scheduling and register allocation in large basic blocks"
// (1988): while registers are free, the statement on the longest path to a result comes next; else the one behind which
// the most values are dead. Calls of the library come as soon as they can, those of one operand together: a call needs
// all registers, and a compiler makes one call of a sine and a cosine.
//
// The new order is taken where it is the better: in a body of one part, if fewer values wait without a register; in a
// longer one, if at least a tenth fewer live from part to part. A body whose values find room in registers as it stands
// keeps the order of the source; so does a body with blocks, with calls of external functions, or of more than 200 000
// statements. `is_read`: nodes that are found in an array. n log n.
void schedule_for_registers(Graph const &graph, std::vector<char> const &is_read, FunctionBody &body);

} // namespace symreal
