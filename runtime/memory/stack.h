// Bounds of this thread's stack.
#pragma once

#include <cstddef>

namespace symreal::memory {

// Both are nullptr if the system does not report them.
struct Stack {
  char *begin = nullptr, *end = nullptr;

  static Stack of_this_thread();
  std::size_t size() const { return static_cast<std::size_t>(end - begin); }
};

} // namespace symreal::memory
