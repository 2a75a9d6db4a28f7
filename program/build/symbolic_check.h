// Check that each rewritten source compiles in symbolic mode: a compiler parses it and writes nothing.
#pragma once

#include "program/build/compile.h"

#include <vector>

namespace symreal::program {

// One diagnostic for each source that fails, in the order of `request.sources`, with places in the user's sources.
// `rewritten`: their rewriting.
std::vector<Diagnostic> symbolic_check(BuildRequest request, rewrite::Result rewritten);

} // namespace symreal::program
