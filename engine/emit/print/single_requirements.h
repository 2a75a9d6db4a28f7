// What of a graph, or of an option, single precision cannot say.
#pragma once

#include "engine/emit/language/emitted.h"
#include "engine/emit/language/language.h"

namespace symreal {

// Throws bad_option where the language has no such numbers, or the kernel needs more than they hold.
void require_single(Graph const &graph, Language const &language, EmitOptions const &options);

} // namespace symreal
