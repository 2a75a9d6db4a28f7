// The source file of a generated kernel: its functions, preceded by the code that they use.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

EmittedFile print_source(Emission &emission);

// First lines of every generated file, for verification and for readers. One line is JSON, so that a tool can recognise
// the file as its own.
std::string banner(Emission const &emission);

} // namespace symreal
