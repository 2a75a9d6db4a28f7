// The trap for symbolic values in code that does not know them. A node is a signalling NaN, so an instruction that
// computes with one raises FE_INVALID. While a kernel is recorded this exception is unmasked in the recording thread:
// the operands of the instruction tell a leak, which is reported with its place, from an invalid operation of the
// program's own (0/0, the root of -1). Either way the program goes on as the original would: with the carried values,
// or with the original's result.
//
// Only on x86-64 Linux; elsewhere comparisons, conversions, fmin and fmax in foreign code go unseen.
#pragma once

namespace symreal::trace {

// Called at a kernel's begin and end, in its thread. SIGFPE and SIGTRAP get a handler in between, which passes other
// signals on.
void enable_trap();
// Whether the trap was in force all the time: a program that sets the floating-point environment or the handler itself
// switches it off.
[[nodiscard]] bool disable_trap();

} // namespace symreal::trace
