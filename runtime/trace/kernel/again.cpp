#include "runtime/trace/kernel/again.h"

#include "runtime/memory/heap_blocks.h"

#include <symreal/original.h>

#include <csetjmp>
#include <cstring>
#include <vector>

#ifdef __x86_64__

namespace symreal::trace {
namespace {

thread_local std::jmp_buf point;
thread_local char *frame_begin = nullptr;
thread_local std::vector<char> frame_bytes;
thread_local bool is_again = false;

} // namespace

void run_again() {
  if (!frame_begin) return;
  // The function's frame lies above this one.
  is_again = true;
  std::memcpy(frame_begin, frame_bytes.data(), frame_bytes.size());
  std::longjmp(point, 1);
}

} // namespace symreal::trace

void *symreal_original_point() { return symreal::trace::point; }

void symreal_original_keep(void const *frame) {
  using namespace symreal::trace;
  if (is_again) return; // only the first state is kept
  symreal::memory::OwnWork const own;
  // The bytes from the end of the function's stack, where this frame begins, to its saved registers.
  frame_begin = static_cast<char *>(__builtin_frame_address(0)) + 2 * sizeof(void *);
  frame_bytes.assign(frame_begin, static_cast<char *>(const_cast<void *>(frame)));
}

#else

void symreal::trace::run_again() {}

#endif
