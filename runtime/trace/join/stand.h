// Stack frame of a program that asks for the outcome of a decision: all that lives beyond the call lies from here to
// the far end of the stack, the callee-saved registers first. So the program can be stopped, compared with another
// process at the same place, given other numbers, and resumed.
#pragma once

#include <cstdint>

namespace symreal::trace {

// Layout of the entry's frame (trace/decisions/stand.cpp). The caller's stack follows.
struct Stand {
  std::uint64_t preserved[6];
  std::uint64_t condition;
  void const *caller;
};

} // namespace symreal::trace
