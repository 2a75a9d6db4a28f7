// Reads a source that asks about types again, as the symbolic program's compiler will see it, and compares what the
// language chooses there with what it has chosen in the original.
#pragma once

#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

struct Scope;

// Each choice that is another one in the symbolic program becomes a diagnostic. What does not compile says nothing.
void compare_choices(Choices const &original, std::vector<Compilation> const &asking, Scope const &scope,
                     Request const &request, Result &result);

} // namespace symreal::rewrite
