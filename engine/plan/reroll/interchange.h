// Loop interchange: stage by stage in place of chain by chain.
//
// The inner one of two nested loops often waits for itself from iteration to iteration, as when a force goes from link
// to link to the base, and after it the next one. Recorded are chains of operations then, one for each iteration of the
// outer loop, whose ends are alike: they compute the same with the same operands. They do not wait for each other. So
// the last stage that all chains have is computed for all of them, side by side, and so is each stage before: what one
// stage computes becomes a loop whose iterations compilers may carry out at the same time.
//
// Stages that are alike, each or every second or third one, become rows: a row computes so many stages of all chains
// that have them, and all rows are one loop in another.
#pragma once

#include "engine/plan/reroll/repeats.h"

namespace symreal::reroll {

struct Interchanged {
  Sequence sequence;
  std::vector<Repeat> stages = {}; // that are worth a loop, in order, and rows
};

// Time is that of sorting the sequence. `in_rows`: whether stages may become rows.
Interchanged interchanged(Sequence sequence, bool in_rows);

} // namespace symreal::reroll
