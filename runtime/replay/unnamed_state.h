// State that no clause names, found by trying: the kernel runs on from its inputs in forks of the process. One fork
// tells which bytes of memory that outlives the kernel it reads before it writes them, and which it writes
// (access_watch.h). Further forks begin with other bytes there. If the outputs depend on them, the kernel reads state;
// if bytes that were changed are overwritten, it writes state, be it with what was there.
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

// At the kernel's beginning, before its items are looked up. `changeable`: a file of the static variables that the
// program may change, a line each, and behind a star those that lead to what it may change; of others nothing is asked.
void begin_examination(memory::MemoryImage const &image, std::string const &changeable);
// Once all inputs are given. Returns in the forks, where the kernel runs on.
void examine_state(memory::MemoryImage const &image);
// Whether items are looked up: what is read for that alone is named.
void look_up_items(bool are_looked_up);
// At the kernel's end.
void end_examined(memory::MemoryImage const &image, std::function<Named()> const &named);

// Static variables that never change, and what they own does not either.
std::vector<memory::Known> fixed_owners(memory::MemoryImage const &image);

} // namespace symreal::replay
