// Loop interchange: computes chains stage by stage instead of one after the other.
//
// The inner loop of a nest is often a recurrence, as when a force is handed from link to link down to the base, and
// then the next force. The recording then has one chain of operations per outer iteration; chains are independent, and
// their ends are alike: the same operations on the same operands. So the last stage, which all chains have, is computed
// for all chains side by side, and likewise each stage before it: a stage becomes a loop with independent iterations,
// which compilers can vectorise.
//
// Stages that repeat with a short period become rows: a row computes one period of stages for all chains that have
// them, and all rows form one loop nest.
#pragma once

#include "engine/plan/reroll/repeats.h"

namespace symreal::reroll {

struct Interchanged {
  Sequence sequence;
  std::vector<Repeat> stages = {}; // worth a loop, in order, and rows
};

// Takes the time of sorting the sequence. `in_rows`: whether stages may become rows.
Interchanged interchanged(Sequence sequence, bool in_rows);

} // namespace symreal::reroll
