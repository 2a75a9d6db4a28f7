// Explanations of decisions that did not become selects: what the rewriter found in the way.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "rewrite/rewrite.h"

#include <vector>

namespace symreal::program {

// Adds to each diagnostic about a decision a note at the token that blocks its `if`, `?:` or loop.
void explain_refusals(std::vector<Diagnostic> &diagnostics, std::vector<rewrite::Refusal> const &refusals);

} // namespace symreal::program
