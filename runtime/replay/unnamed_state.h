// Search by trial for state that no clause names: the kernel runs on from its inputs in forks of the process. One fork
// reports which bytes of memory that outlives the kernel it reads before it writes them, and which it writes
// (access_watch.h). Further forks begin with other bytes there. If the outputs depend on them, the kernel reads state;
// if changed bytes are overwritten, even with their old values, it writes state.
//
// Bytes that are read without effect on the outputs are not reported. Pointers are left as they are; their targets are
// tried themselves.
#pragma once

#include "runtime/memory/memory_image.h"

#include <functional>
#include <string>
#include <vector>

namespace symreal::replay {

// Bytes that the clauses let the kernel read, and write.
struct Named {
  std::vector<memory::Known> read, written;
};

// Begins at the kernel's begin, before its items are looked up. `changeable`: a file of the static variables that the
// program may change, a line each, with a star before those that only lead to what may change; others are not examined.
void begin_examination(memory::MemoryImage const &image, std::string const &changeable);
// Examines once all inputs are given. Returns in the forks, where the kernel runs on.
void examine_state(memory::MemoryImage const &image);
// Sets whether items are being looked up: reads for that alone count as named.
void look_up_items(bool are_looked_up);
// Ends at the kernel's end.
void end_examined(memory::MemoryImage const &image, std::function<Named()> const &named);

// Static variables that never change, nor does what they own.
std::vector<memory::Known> fixed_owners(memory::MemoryImage const &image);

} // namespace symreal::replay
