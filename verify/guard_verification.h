// Verification of guards: generated code must refuse a sample exactly if the original decides otherwise than recorded.
#pragma once

#include "verify/generated_code.h"
#include "verify/verification.h"

namespace symreal::program {

// Checks the guard that the code returned. `failing`: the first guard of the recorded graph that does not hold, or the
// number of guards if all hold. The code may lack a guard that follows from others; then a later guard of the graph may
// fail in its place. Counts mismatches and keeps the first.
void check_guards(Graph const &graph, std::size_t failing, GeneratedCode::Result const &result, std::size_t sample,
                  Verification &verification);

} // namespace symreal::program
