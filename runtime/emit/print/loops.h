// A function of loops: a function of the file for each step, and one that calls them.
#pragma once

#include "emit/print/code_text.h"
#include "emit/print/emission.h"

namespace symreal {

CodeText print_loops(Emission &emission, reroll::LoopFunction const &function, bool is_compute);

} // namespace symreal
