// Does each rewritten source compile in symbolic mode? A compiler parses it, and makes nothing.
#pragma once

#include "program/build/compile.h"

#include <vector>

namespace symreal::program {

// One diagnostic for each source that does not, in the order of `request.sources`, with places in the user's sources.
// `rewritten`: what becomes of these.
std::vector<Diagnostic> symbolic_check(BuildRequest request, rewrite::Result rewritten);

} // namespace symreal::program
