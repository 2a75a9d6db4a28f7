// Name clashes between external functions and the generated file.
#pragma once

#include "engine/emit/language/emitted.h"
#include "engine/emit/print/emission.h"

#include <vector>

namespace symreal {

// Fails if a language that calls external functions directly uses the name of one otherwise: as a function, a variable,
// a macro or a keyword. `files`: the printed files.
void require_other_names(Emission const &emission, std::vector<EmittedFile> const &files);

} // namespace symreal
