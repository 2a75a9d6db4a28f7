// Repeated runs of a kernel's function within one call of it: from its end the program jumps back to its beginning. The
// function's own objects are then as at the first time, objects that outlive it as it has left them.
#pragma once

namespace symreal::trace {

// Jumps back if the function has set the target (<symreal/original.h>); else does nothing.
void run_again();

} // namespace symreal::trace
