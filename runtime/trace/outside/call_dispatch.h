// System calls of this thread handed over as a signal (syscall user dispatch, Linux 5.11): the handler is asked in
// place of the system. Signals of one handler at a time.
//
// Linux on x86-64 only.
#pragma once

#include <csignal>
#include <ucontext.h>

namespace symreal::trace {

#if defined(__linux__) && defined(__x86_64__)

using CallHandler = void(int, siginfo_t *, void *);

// False where the system cannot do that. Calls go to the system until set_dispatch(true), and while it is off again.
bool begin_dispatch(CallHandler *handler);
void end_dispatch();
void set_dispatch(bool is_on);
// The same in a copy of the process, which the system does not dispatch.
bool dispatch();

struct SystemCall {
  long number;
  long arguments[6];
};
SystemCall call_in(gregset_t const &registers);
// The system's answer; in the handler, which turns the dispatch off first.
long carry_out(long number, long const (&arguments)[6]);

#endif

// Ends this process at the next system call of this thread, unless the runtime makes it for itself and it leaves
// nothing behind. Returns false where the system or the program does not let it.
bool refuse_calls(bool are_refused);

} // namespace symreal::trace
