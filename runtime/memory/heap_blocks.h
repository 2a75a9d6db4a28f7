// The blocks of the heap that the program has and has not given back: told by the allocation functions
// (trace/heap_hooks.cpp), where these are linked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace symreal::memory {

struct HeapBlock {
  char *begin;
  std::size_t size;
  std::uint64_t serial; // tells a block from a later one at the same address
};

// What the bookkeeping of the runtime allocates is no block of the program's. May be nested.
class OwnWork {
public:
  OwnWork() { ++depth_; }
  ~OwnWork() {
    if (--depth_ == 0 && at_end_) at_end_();
  }
  OwnWork(OwnWork const &) = delete;
  OwnWork &operator=(OwnWork const &) = delete;
  static bool is_going_on() { return depth_ != 0; }
  // Called when the outermost one ends; null: nothing is.
  static void call_at_end(void (*function)()) { at_end_ = function; }

private:
  static __thread int depth_;
  static void (*at_end_)();
};

// What lives as long as its thread, or longer.
template <class T> T *make_own() {
  OwnWork const own;
  return new T;
}

// `caller`: the code that asked for it. What the C library keeps for itself, such as the buffer of a file, is left out.
void note_allocated(void *block, std::size_t size, void const *caller);
void note_released(void *block);
// By address.
std::vector<HeapBlock> heap_blocks();

} // namespace symreal::memory
