// A kernel's function is run several times in a row, within one call of it: from its end the program jumps back to its
// beginning. What the function itself has is then as it was at the first time, what outlives it as it was left.
#pragma once

namespace symreal::trace {

// Jumps back, if the function has said where to (<symreal/original.h>); else does nothing.
void run_again();

} // namespace symreal::trace
