// Server side of a replay program: at the first annotation of the wanted kernel the process becomes a fork server, and
// each fork runs the kernel once on inputs of the client's choice. Without the environment of replay_protocol.h, and
// for every other kernel, the functions do nothing, and the program runs on as the original would.
#pragma once

#include "runtime/memory/memory_image.h"
#include "runtime/replay/replay_protocol.h"

#include <cstdint>
#include <functional>
#include <string_view>

namespace symreal::replay {

// Callbacks by which a program reports on its memory and its system calls.
struct Memory {
  std::function<void()> prepare = [] {}; // before the first fork
  // Changes since `prepare`; called after generated code that calls functions of the program.
  std::function<std::vector<memory::Change>()> changes = [] { return std::vector<memory::Change>(); };
  // Call stack: return addresses relative to the load base, innermost first.
  std::function<std::vector<std::uintptr_t>()> stack = [] { return std::vector<std::uintptr_t>(); };
  // Sets whether a system call of the kernel ends the process; false where it cannot.
  bool (*refuse_calls)(bool) = [](bool) { return false; };
};

// Called at the first annotation. Returns true in the forks, false for a kernel that is not wanted.
bool replay_begin(std::string_view kernel, Memory const &memory = {});

// Per annotated number, in order: inputs and parameters receive their value, an output is kept for the client. A null
// pointer stands for a temporary, which cannot be given a value.
void replay_input(double *number);
void replay_parameter(double *number);
void replay_output(double value);
// Called before the outputs are read.
void replay_leave();

// The kernel's generated code, in the program of the original: 0, or the guard that does not hold.
int replay_compute(double const *inputs, double const *parameters, double *outputs);

// Reports the changes that the kernel has left in memory.
void replay_left(std::vector<memory::Change> const &changes);

// Whether the client asks for the effects of this call outside of the program, and one such effect.
bool replay_watches_world();
// Whether later calls may use other formats of the standard streams.
bool replay_changes_formats();
void replay_effect(Outside kind, std::string_view what);

// Whether the client asks for state that no clause names; whether all inputs are given, so that forks may run the
// kernel on from here.
bool replay_examines();
bool replay_is_fed();
enum class Ran { here, well, badly };
// `here` in the fork, which ends with the kernel or after so many seconds.
Ran replay_in_fork(unsigned seconds);
// The outputs of the fork that ran last.
std::vector<double> replay_outputs();
void replay_unnamed(UnnamedObject const &object);
void replay_unexamined(std::string_view why);

// The members of the returned object that are not numbers: generated code has the numbers alone. `others` says where
// they lie (rewrite/facts/result.h).
void replay_returned(char const *object, std::string_view others);

// The change in the form that the client receives.
LeftBehind left_behind(memory::Change const &change);

// Per input, in order: the output that is the same number, or -1.
void replay_link(int output);

// Whether the kernel is to run once more, on the state that it has left.
bool replay_again();

// Ends the kernel, and with it the fork.
void replay_end();
// The end of a fork that has run the kernel in further ones.
[[noreturn]] void replay_examined();

} // namespace symreal::replay
