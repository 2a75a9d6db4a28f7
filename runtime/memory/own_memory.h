// Classification of memory that is the kernel's own, such as its part of the stack, or constant, independent of the
// kernel's actions.
#pragma once

#include "runtime/memory/heap_blocks.h"

#include <symreal/state.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace symreal {

namespace memory {

// Bounds of this thread's stack; both are nullptr if the system does not report them.
struct Stack {
  char *begin = nullptr, *end = nullptr;

  static Stack of_this_thread();
  std::size_t size() const { return static_cast<std::size_t>(end - begin); }
};

} // namespace memory

namespace trace {

struct MemoryRange {
  std::uintptr_t begin, end;
  bool contains(void const *address) const {
    auto const at = reinterpret_cast<std::uintptr_t>(address);
    return begin <= at && at < end;
  }
};

// The stack of this thread from its far end to the frame (all of it where no frame is given) is the kernel's own.
void find_own_stack(void const *frame);
// A local of the function around the kernel lies there.
void widen_around(void const *begin, std::size_t size);

// Read-only memory of the program and its libraries.
std::vector<MemoryRange> find_constant_memory();

// The caller's data may be constant, which an input is not. Whether it can be written now.
bool make_writable(void const *begin, std::size_t size = sizeof(double));

// The bookkeeping's own work: its allocations are not memory of the kernel, and errno stays as it is.
class Pause {
public:
  Pause() { detail::recording = false; }
  ~Pause() {
    detail::recording = before_;
    errno = error_;
  }
  Pause(Pause const &) = delete;
  Pause &operator=(Pause const &) = delete;

private:
  bool const before_ = detail::recording;
  int const error_ = errno;
  memory::OwnWork const own_;
};

} // namespace trace
} // namespace symreal
