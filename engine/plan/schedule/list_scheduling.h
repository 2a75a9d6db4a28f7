// List scheduling of statements for low register pressure.
#pragma once

#include "engine/plan/schedule/schedule.h"

namespace symreal {

// List scheduling with two priorities, after Goodman and Hsu, "Code scheduling and register allocation in large basic
// blocks" (1988): while registers are free, the statement on the longest path to a result comes next; else the one that
// ends the most live ranges. Library calls come as early as possible, those of one operand together: a call clobbers
// all registers, and compilers merge a sine and a cosine into one call.
//
// The new order replaces the old one only if it is better: in a body of one part, if fewer values are spilled; in a
// longer one, if at least a tenth fewer live from part to part. A body keeps its source order if its values fit into
// registers, or if it has blocks, calls of external functions, or more than 200 000 statements. `is_read`: nodes that
// are read from arrays. Takes O(n log n) time.
void schedule_for_registers(Graph const &graph, std::vector<char> const &is_read, FunctionBody &body);

} // namespace symreal
