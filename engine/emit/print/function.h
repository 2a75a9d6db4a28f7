// Printing of a schedule's functions: a single walk over statements and blocks for all languages.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/emit/print/function_plan.h"

namespace symreal {

// Prints a function; a long one as local functions that the last one calls.
CodeText print_function(Emission &emission, FunctionKind kind);

} // namespace symreal
