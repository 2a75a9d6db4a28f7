// From a schedule to source text in a language: what languages.def lists.
#pragma once

#include "engine/emit/language/emitted.h"
#include "engine/emit/languages/languages.h"
#include "engine/plan/lanes/lanes.h"
#include "engine/plan/reroll/reroll.h"
#include "engine/plan/schedule/schedule.h"

#include <vector>

namespace symreal {

// The source first, then what stands beside it, and on request a program that runs it. In C these are the functions,
// with `prefix_` before their names if a prefix is given,
//   void preprocess(double const *parameters, double *constants);
//   void compute(double const *input, double const *constants, double *output);
// All inputs are read before an output is written, so the arrays may overlap. Nothing is allocated, no state is kept.
// With guards compute is an int: 0, or k + 1 for the first guard, k, that does not hold; output is untouched then. Then
// there also are
//   enum { guard_count = n };
//   char const *guard_text(int guard);
// Throws bad_option where the language cannot say what the graph needs.
// With `loops`, these are printed in place of the statements of the schedule that they were found in.
// With `lanes`, function compute has them where compiler and processor do, and is that of the schedule elsewhere.
std::vector<EmittedFile> emit(Schedule const &plan, Language const &language, EmitOptions const &options,
                              Rerolled const *loops = nullptr, Laned const *lanes = nullptr);

} // namespace symreal
