// Graph to C99: a source with preprocess() and compute(), a header, and on request a runnable main.
#pragma once

#include "emit/print/emitted.h"

#include <string>
#include <vector>

namespace symreal {

// The generated functions, with `prefix_` before their names if a prefix is given:
//   void preprocess(double const *parameters, double *constants);
//   void compute(double const *input, double const *constants, double *output);
// All inputs are read before an output is written, so the arrays may overlap. Nothing is allocated, no state is kept.
// With guards compute is an int: 0, or k + 1 for the first guard, k, that does not hold; output is untouched then. Then
// there also are
//   enum { guard_count = n };
//   char const *guard_text(int guard);
std::vector<EmittedFile> emit_c(Graph const &graph, EmitOptions const &options);

} // namespace symreal
