// Live heap blocks of the program, as the allocation functions report them (trace/heap_hooks.cpp), where these are
// linked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace symreal::memory {

struct HeapBlock {
  char *begin;
  std::size_t size;
  std::uint64_t serial; // distinguishes a block from a later one at the same address
};

// Scope whose allocations are the runtime's own and not recorded as blocks of the program. Scopes may be nested.
class OwnWork {
public:
  OwnWork() { ++depth_; }
  ~OwnWork() {
    if (--depth_ == 0 && at_end_) at_end_();
  }
  OwnWork(OwnWork const &) = delete;
  OwnWork &operator=(OwnWork const &) = delete;
  static bool is_going_on() { return depth_ != 0; }
  // Sets the function to call at the end of the outermost scope; null: none.
  static void call_at_end(void (*function)()) { at_end_ = function; }

private:
  static __thread int depth_;
  static void (*at_end_)();
};

// Allocates an object of the runtime that lives at least as long as its thread.
template <class T> T *make_own() {
  OwnWork const own;
  return new T;
}

// `caller`: the allocating code. Blocks that the C library allocates for itself, such as file buffers, are left out.
void note_allocated(void *block, std::size_t size, void const *caller);
void note_released(void *block);
// Live blocks, sorted by address.
std::vector<HeapBlock> heap_blocks();

} // namespace symreal::memory
