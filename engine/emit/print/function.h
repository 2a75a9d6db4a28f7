// The functions of a schedule in a language: the one walk over statements and blocks.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/emit/print/function_plan.h"

namespace symreal {

// A long one becomes functions of the file's own that the last one calls.
CodeText print_function(Emission &emission, FunctionKind kind);

} // namespace symreal
