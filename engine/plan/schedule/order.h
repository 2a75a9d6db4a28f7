// Statement order of a function body: operands first, values computed late, and few of them live at a time.
#pragma once

#include "engine/plan/schedule/regions.h"

namespace symreal {

// Sorts the variables, given in node order, so that each follows its operands and the conditions of its region, and
// adds the gates. Without regions the node order stays. A gate of alternatives is released if its alternatives depend
// on a node that it guards. `is_read`: nodes that are read from arrays. Iterative; linear time.
void order(Graph const &graph, std::vector<char> const &is_read, Placement &placement, PlanFunction &body);

// Sinks statements of a long function: moves a statement down to its first reader if the operands live that long
// anyway: then fewer values are live at any point, and fewer cross chunks. Statements in blocks and those that
// conditions read stay. `is_read`: nodes that are read from arrays. Linear time.
void delay(Graph const &graph, std::vector<char> const &is_read, std::vector<NodeId> const &conditions,
           PlanFunction &body);

// List scheduling with two priorities, after Goodman and Hsu, "Code scheduling and register allocation in large basic
// blocks" (1988): while registers are free, the statement on the longest path to a result comes next; else the one that
// ends the most live ranges. Library calls come as early as possible, those of one operand together: a call clobbers
// all registers, and compilers merge a sine and a cosine into one call.
//
// The new order replaces the old one only if it is better: in a body of one part, if fewer values are spilled; in a
// longer one, if at least a tenth fewer live from part to part. A body keeps its source order if its values fit into
// registers, or if it has blocks, calls of external functions, or more than 200 000 statements. `is_read`: nodes that
// are read from arrays. Takes O(n log n) time.
void schedule_for_registers(Graph const &graph, std::vector<char> const &is_read, PlanFunction &body);

} // namespace symreal
