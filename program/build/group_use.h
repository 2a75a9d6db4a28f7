// The processor time and memory that a group of processes has taken so far, its ended processes included where another
// one of the group has waited for them. Read from /proc.
#pragma once

#include <cstddef>
#include <sys/types.h>

namespace symreal::program {

struct GroupUse {
  double seconds = 0;
  std::size_t most_memory = 0; // in bytes, of the largest of them
};

GroupUse use_of_group(pid_t group);

} // namespace symreal::program
