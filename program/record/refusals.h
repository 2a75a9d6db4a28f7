// Why a decision that was met has not become a select: what the rewriter found in its way.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "rewrite/rewrite.h"

#include <vector>

namespace symreal::program {

// Each diagnostic about a decision gets a note at the token that blocks its `if`, `?:` or loop.
void explain_refusals(std::vector<Diagnostic> &diagnostics, std::vector<rewrite::Refusal> const &refusals);

} // namespace symreal::program
