// --reroll: operations that repeat as loops.
//
// A recorded program is one long sequence of operations. Where the source had a loop, windows of it are alike but for
// their inputs, constants and what they take from other windows. One window becomes the body of a loop; what differs
// becomes an index that grows, a table, or a variable that is carried on. docs/reference/reroll.md says more.
#pragma once

#include "engine/ops/floating_point.h"
#include "engine/plan/reroll/bodies.h"
#include "engine/plan/schedule/schedule.h"

#include <optional>
#include <string>

namespace symreal {

// The functions that have loops.
struct Rerolled {
  std::optional<reroll::LoopFunction> preprocess, compute, computed_angles = {};
  std::string why_not = {}; // where none has

  bool has_loops() const { return preprocess || compute || computed_angles; }
};

// What is found is proved (check.h) whenever this runs. In modes other than strict, signs are chosen so that
// few iterations multiply by them (signs.h).
Rerolled rerolled(Schedule const &plan, FloatingPoint mode);

// With passes over what the loops and the stretches between them compute (bodies.h).
Rerolled improved(Rerolled loops, Angles const &angles, reroll::Improve const &improve);

// What function compute does in its loops and between them, and before them for sines and cosines. It has loops.
OperationCounts executed_operations(Schedule const &plan, Rerolled const &loops);

// How much of the operations the loops hold, in words.
std::string describe(Rerolled const &loops);

} // namespace symreal
