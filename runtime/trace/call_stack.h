// Where the program stands, as return addresses: innermost first, relative to the load base.
#pragma once

#include <cstdint>
#include <vector>

namespace symreal::trace {

// The callers. The driver leaves the recorder's own frames out.
std::vector<std::uintptr_t> call_stack();

// In a signal handler: what it has interrupted, from the instruction itself on. If that tells late of what another
// instruction did, `delayed` is the other one.
std::vector<std::uintptr_t> interrupted_stack(std::uintptr_t delayed);

} // namespace symreal::trace
