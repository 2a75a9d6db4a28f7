// Watch on the system calls of this thread. Linux hands each over as a signal (syscall user dispatch, Linux 5.11),
// whose handler notes it and carries it out; where the system cannot do that, nothing is noted. Actions of signals are
// compared, too, since calls may change them for a while.
//
// Linux on x86-64 only.
#pragma once

#include "runtime/trace/outside/world.h"

namespace symreal::trace {

void watch_calls();
// Ends the watch and adds the effects of the calls.
void end_calls(std::vector<Effect> &effects);
// Sets whether what the program writes while it is watched is thrown away.
void discard_output(bool discard);

} // namespace symreal::trace
