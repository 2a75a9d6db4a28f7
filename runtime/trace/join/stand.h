// Where a program stands when it asks for the outcome of a decision: what lives beyond the call lies from here to the
// far end of the stack, the registers that a call preserves first. So the program can be stopped, compared with
// another process that stands at the same place, given other numbers, and sent on.
#pragma once

#include <cstdint>

namespace symreal::trace {

// As the entry lays it out (trace/decisions/stand.cpp). The caller's stack follows.
struct Stand {
  std::uint64_t preserved[6];
  std::uint64_t condition;
  void const *caller;
};

} // namespace symreal::trace
