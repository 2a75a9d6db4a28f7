// The source file of a generated kernel: its functions, and before them what these use.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

EmittedFile print_source(Emission &emission);

// The first lines of every generated file: what verification and people need to know of it. One line is JSON, so that a
// tool can recognise the file as its own.
std::string banner(Emission const &emission);

} // namespace symreal
