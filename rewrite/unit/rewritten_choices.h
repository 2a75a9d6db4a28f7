// Check of the language's choices: reads a source that asks about types again, as the symbolic program's compiler will
// see it, and compares its choices with those in the original.
#pragma once

#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

struct Scope;

// Reports each choice that differs in the symbolic program. A source that does not compile reports nothing.
void compare_choices(Choices const &original, std::vector<Compilation> const &asking, Scope const &scope,
                     Request const &request, Result &result);

} // namespace symreal::rewrite
