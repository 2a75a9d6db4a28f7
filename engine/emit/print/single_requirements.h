// Check of a graph and the options for features that single precision lacks.
#pragma once

#include "engine/emit/language/emitted.h"
#include "engine/emit/language/language.h"

namespace symreal {

// Throws bad_option if the language lacks single precision, or the kernel needs wider numbers.
void require_single(Graph const &graph, Language const &language, EmitOptions const &options);

} // namespace symreal
