// Checks of a graph and the options against the features of a language; each throws bad_option.
#pragma once

#include "engine/emit/print/emission.h"

#include <vector>

namespace symreal {

// Throws if the language lacks a feature that the graph or an option requires.
void require_expressible(Plan const &plan, Language const &language, EmitOptions const &options);

// Throws if the language lacks single precision, or the kernel needs wider numbers.
void require_single(Graph const &graph, Language const &language, EmitOptions const &options);

// Throws if a language that calls external functions directly uses the name of one otherwise: as a function, a
// variable, a macro or a keyword. `files`: the printed files.
void require_other_names(Emission const &emission, std::vector<EmittedFile> const &files);

} // namespace symreal
