// --reroll: turns repeated operations back into loops.
//
// A recorded program is one long sequence of operations. A loop of the source appears in it as windows that differ only
// in inputs, constants, and values from other windows. One window becomes the body of a loop; the differences become an
// affine index, a table, or a loop-carried variable. Details: docs/reference/reroll.md.
//
//   sequence ──▶ interchange ──▶ repeats ──▶ plan ──▶ signs ──▶ check           (loops_of in reroll.cpp)
//
// The plan has the columns of each repeat, their roles, the layout of memory, and the stores of results.
#pragma once

#include "engine/ops/floating_point.h"
#include "engine/plan/plan.h"
#include "engine/plan/reroll/bodies.h"

#include <map>
#include <string>

namespace symreal {

// Loops that replace the statements of functions.
struct Rerolled {
  std::map<FunctionKind, reroll::LoopFunction> functions = {}; // those with loops
  std::string why_not = {};                                    // the reason, if no function has loops

  bool has_loops() const { return !functions.empty(); }
};

// Rerolls all functions and proves the result (check.h). In modes other than strict, signs are chosen so that few
// iterations multiply by them (signs.h).
Rerolled rerolled(Plan const &plan, FloatingPoint mode);

// Applies passes to the bodies of loops and straight pieces (bodies.h).
Rerolled improved(Rerolled loops, Angles const &angles, reroll::Improve const &improve);

// Operations that compute executes in total, including the loops for sines and cosines. Requires loops.
OperationCounts executed_operations(Plan const &plan, Rerolled const &loops);

// The plan with these loops.
Plan with_loops(Plan plan, Rerolled loops);

// Description of the share of operations that the loops cover.
std::string describe(Rerolled const &loops);

} // namespace symreal
