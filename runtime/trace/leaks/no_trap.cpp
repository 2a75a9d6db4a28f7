// Machines that the trap does not know.
#include "runtime/trace/leaks/trap.h"

namespace symreal::trace {

void enable_trap() {}
bool disable_trap() { return true; }

} // namespace symreal::trace
