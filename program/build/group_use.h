// Processor time and memory used by a process group, including ended processes that another one of the group has waited
// for. Read from /proc.
#pragma once

#include <cstddef>
#include <sys/types.h>

namespace symreal::program {

struct GroupUse {
  double seconds = 0;
  std::size_t most_memory = 0; // in bytes, of the largest process
};

GroupUse use_of_group(pid_t group);

} // namespace symreal::program
