// Effects of a kernel outside of the program: on files, the environment and processes. Its system calls are
// watched between two moments (system_calls.h), and the environment and the formats of the standard streams are
// compared. Output that the C library keeps in its buffers is written while the calls are watched. Functions that
// change the libraries' own state tell of it (effect_hooks.cpp).
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

// Gives each standard stream another format, so that output that depends on it shows.
void change_formats();

} // namespace symreal::trace
