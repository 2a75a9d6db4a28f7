// Emission: turns a plan into source text in one of the languages of languages.def.
#pragma once

#include "engine/emit/language/emitted.h"
#include "engine/emit/languages/languages.h"
#include "engine/plan/schedule/schedule.h"

#include <vector>

namespace symreal {

// Files: the source, its companions, and on request a program that runs it. In C the functions are, with `prefix_`
// before their names if a prefix is given,
//   void preprocess(double const *parameters, double *constants);
//   void compute(double const *input, double const *constants, double *output);
// All inputs are read before an output is written, so the arrays may overlap. Nothing is allocated, no state is kept.
// With guards compute returns an int: 0, or k + 1 for the first guard, k, that fails; output is then unchanged. The
// file also has
//   enum { guard_count = n };
//   char const *guard_text(int guard);
// Throws bad_option if the language cannot express the graph. Vector code is for compilers and processors with vectors;
// others get the statements.
// The plan must have the language's form.
std::vector<EmittedFile> emit(Plan const &plan, Language const &language, EmitOptions const &options);

// The form in which the language takes plans. `angles`: with sines and cosines side by side, where it has them.
inline PlanForm form_of(Language const &language, bool angles = false) {
  return {language.has_blocks, angles && language.angles.is_given()};
}

} // namespace symreal
