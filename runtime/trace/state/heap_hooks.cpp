// Hooks for the allocation functions of the C library, in the whole program, so that a recording knows its own memory,
// and a memory image the blocks of the heap. Linked on request only (-u symreal_heap_hooks): a sanitizer brings its
// own.
//
// Weak, so that a program with an allocator of its own links; the recording notices the missing reports.
#include "runtime/memory/heap_blocks.h"
#include "runtime/trace/state/state.h"

#ifdef __GLIBC__

#include <symreal/state.h>

#include <cerrno>
#include <malloc.h>

using symreal::detail::recording;
using symreal::trace::session;

extern "C" {

char symreal_heap_hooks = 0;
extern char symreal_outside_hooks, symreal_mapping_hooks, symreal_initialisation_hooks, symreal_effect_hooks;
// Links them as well.
char const *symreal_other_hooks[] = {&symreal_outside_hooks, &symreal_mapping_hooks, &symreal_initialisation_hooks,
                                     &symreal_effect_hooks};

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *block, size_t size);
void *__libc_memalign(size_t alignment, size_t size);
void __libc_free(void *block);

[[gnu::always_inline]] static inline void *noted(void *block, size_t size) {
  symreal::memory::note_allocated(block, size, __builtin_return_address(0));
  if (recording && block) session().state.allocated(block, malloc_usable_size(block));
  return block;
}

[[gnu::weak]] void *malloc(size_t size) { return noted(__libc_malloc(size), size); }
[[gnu::weak]] void *calloc(size_t count, size_t size) { return noted(__libc_calloc(count, size), count * size); }
[[gnu::weak]] void *memalign(size_t alignment, size_t size) { return noted(__libc_memalign(alignment, size), size); }
[[gnu::weak]] void *aligned_alloc(size_t alignment, size_t size) {
  return noted(__libc_memalign(alignment, size), size);
}

[[gnu::weak]] int posix_memalign(void **block, size_t alignment, size_t size) {
  if (alignment % sizeof(void *) != 0 || (alignment & (alignment - 1)) != 0 || alignment == 0) return EINVAL;
  void *made = noted(__libc_memalign(alignment, size), size);
  if (!made) return ENOMEM;
  *block = made;
  return 0;
}

[[gnu::weak]] void *realloc(void *block, size_t size) {
  if (!block) return noted(__libc_malloc(size), size);
  size_t const before = malloc_usable_size(block);
  void *moved = __libc_realloc(block, size);
  if (moved || size == 0) symreal::memory::note_released(block);
  symreal::memory::note_allocated(moved, size, __builtin_return_address(0));
  if (!recording) return moved;
  if (moved)
    session().state.moved(block, before, moved, malloc_usable_size(moved));
  else if (size == 0)
    session().state.released(block, before);
  return moved;
}

[[gnu::weak]] void free(void *block) {
  if (block) symreal::memory::note_released(block);
  if (recording && block) session().state.released(block, malloc_usable_size(block));
  __libc_free(block);
}

} // extern "C"

#endif
