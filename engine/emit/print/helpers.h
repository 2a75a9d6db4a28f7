// The functions of a language's table that generated code calls.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

// Those that the printed spellings name, and those that these name, in the order of the table: declarations, or
// functions.
std::string print_helpers(Emission const &emission, bool declarations);

} // namespace symreal
