// The names of external functions beside those that the generated file has for itself.
#pragma once

#include "engine/emit/language/emitted.h"
#include "engine/emit/print/emission.h"

#include <vector>

namespace symreal {

// Fails where a language that calls them directly has another use for the name of one: a function, a variable, a macro
// or a keyword. `files`: what was printed.
void require_other_names(Emission const &emission, std::vector<EmittedFile> const &files);

} // namespace symreal
