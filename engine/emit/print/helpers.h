// Helper functions of a language's table that generated code calls.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

// Helpers that printed spellings name, and transitively those that helpers name, in table order: their declarations, or
// their definitions.
std::string print_helpers(Emission const &emission, bool declarations);

} // namespace symreal
