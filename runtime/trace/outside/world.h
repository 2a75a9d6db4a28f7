// Effects of a kernel outside of the program: on files, the environment and processes. Its system calls are
// watched between two moments, and the environment is compared.
//
// Method: Linux hands each system call of this thread over as a signal (syscall user dispatch, Linux 5.11), whose
// handler notes it and carries it out. If the system cannot do that, only the environment is compared. Actions
// of signals are compared, too, since calls may change them for a while. Output that the C library keeps in its buffers
// is written while the calls are watched. Functions that change the libraries' own state tell of it (effect_hooks.cpp).
#pragma once

#include <string>
#include <vector>

namespace symreal::trace {

struct Effect {
  // Text for a person, on standard output or error; a question, whose answer another call may not get; the result of a
  // function of support/outside.def; anything that lasts.
  enum class Kind { prints, asks, reads, changes } kind;
  std::string what; // behind "the kernel": "writes to 'log.txt'"; of a result the name of the function
  bool operator==(Effect const &) const = default;
};

// Begins to watch; effects of OwnWork do not count.
void watch_world();
// A library function changes program-wide state of the library; `what` lives as long.
void note_effect(char const *what);
// A library function returns such state; the name lives as long.
void note_result(char const *function);
// Ends the watch and returns each effect once. `discard`: buffered output is not written.
std::vector<Effect> effects_on_world(bool discard = false);

} // namespace symreal::trace
