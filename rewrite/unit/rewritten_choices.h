// Reads a source that may ask about types again, as it is and as the symbolic program's compiler will see it, and
// compares what the language chooses there.
#pragma once

#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

struct Scope;

// Each choice that is another one in the symbolic program becomes a diagnostic. What does not compile says nothing.
void compare_choices(std::vector<Compilation> const &sources, Scope const &scope, Request const &request,
                     Result &result);

} // namespace symreal::rewrite
