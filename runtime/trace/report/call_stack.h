// Where the program stands, as return addresses: innermost first, relative to the load base.
#pragma once

#include <cstdint>
#include <vector>

namespace symreal::trace {

// The callers. The driver leaves the recorder's own frames out.
std::vector<std::uintptr_t> call_stack();

// In a signal handler, without allocating: `add` is called with what the signal has interrupted and its callers, for
// which the addresses are as above.
void for_each_interrupted(void (*add)(std::uintptr_t address, void *data), void *data);
template <class Add> void for_each_interrupted(Add add) {
  for_each_interrupted([](std::uintptr_t address, void *data) { (*static_cast<Add *>(data))(address); }, &add);
}

// In a signal handler: what it has interrupted, from the instruction itself on. If that tells late of what another
// instruction did, `delayed` is the other one.
std::vector<std::uintptr_t> interrupted_stack(std::uintptr_t delayed);

} // namespace symreal::trace
