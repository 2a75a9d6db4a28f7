// The two functions of a schedule in a language: the one walk over statements and blocks.
#pragma once

#include "emit/print/code_text.h"
#include "emit/print/emission.h"

namespace symreal {

// preprocess or compute. A long one becomes functions of the file's own that the last one calls.
CodeText print_function(Emission &emission, bool is_compute);

} // namespace symreal
