// Live heap blocks of the program, as the allocation functions report them (trace/state/heap_hooks.cpp), where these
// are linked; and whether it maps memory past the heap.
#pragma once

#include <algorithm>
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

// The object that the address lies in, or null. The objects: with `begin` and `size`, by address.
template <class Object> Object const *object_around(std::vector<Object> const &objects, void const *address) {
  auto const *at = static_cast<char const *>(address);
  auto const behind = std::upper_bound(objects.begin(), objects.end(), at,
                                       [](char const *wanted, Object const &one) { return wanted < one.begin; });
  if (behind == objects.begin()) return nullptr;
  Object const &before = *(behind - 1);
  return at < before.begin + before.size ? &before : nullptr;
}

// `caller`: the allocating code. Blocks that the C library allocates for itself, such as file buffers, are left out.
void note_allocated(void *block, std::size_t size, void const *caller);
void note_released(void *block);
// Live blocks, sorted by address.
std::vector<HeapBlock> heap_blocks();

// Whether the program has a writable mapping: the runtime cannot tell which part of it is in use.
bool has_mapped_memory();
void note_mapped_memory();

} // namespace symreal::memory
