// Call stack of the program as return addresses: innermost first, relative to the load base.
#pragma once

#include <cstdint>
#include <vector>

namespace symreal::trace {

// The callers; the driver removes the recorder's own frames.
std::vector<std::uintptr_t> call_stack();

// Calls `add` with the interrupted instruction and its callers, as above, from a signal handler and without allocating.
void for_each_interrupted(void (*add)(std::uintptr_t address, void *data), void *data);
template <class Add> void for_each_interrupted(Add add) {
  for_each_interrupted([](std::uintptr_t address, void *data) { (*static_cast<Add *>(data))(address); }, &add);
}

// The interrupted stack, for a signal handler, from the instruction itself on. `delayed`: the instruction that caused a
// signal delivered late.
std::vector<std::uintptr_t> interrupted_stack(std::uintptr_t delayed);

} // namespace symreal::trace
