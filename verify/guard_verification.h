// Whether generated code refuses exactly where the original decides otherwise than it did while it was recorded.
#pragma once

#include "verify/generated_code.h"
#include "verify/verification.h"

namespace symreal::program {

// What the result should have been on a sample where guard `failing` of the recorded graph is the first that does not
// hold, the number of guards where all hold. The code may lack guards that follow from others: in place of such a one a
// later guard of the graph fails. Counts, and keeps the first mismatch.
void check_guards(Graph const &graph, std::size_t failing, GeneratedCode::Result const &result, std::size_t sample,
                  Verification &verification);

} // namespace symreal::program
