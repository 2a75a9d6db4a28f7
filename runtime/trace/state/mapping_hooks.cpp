// Hooks for the functions by which a program maps memory itself. They replace them in the whole symbolic program, like
// the heap's; the heap gets its own memory by other names.
//
// Weak, so that a program with a function of such a name has its own.
#include "runtime/memory/heap_blocks.h"
#include "runtime/trace/state/state.h"

#include <cstddef>
#include <cstdint>

#ifdef __GLIBC__

#include <dlfcn.h>
#include <sys/mman.h>

extern "C" {

char symreal_mapping_hooks = 0;

#define MAPPING(symbol)                                                                                                \
  void *symreal_mapping_##symbol(void *at, std::size_t size, int protection, int flags, int file,                      \
                                 long offset) asm(#symbol);                                                            \
  [[gnu::weak]] void *symreal_mapping_##symbol(void *at, std::size_t size, int protection, int flags, int file,        \
                                               long offset) {                                                          \
    using Function = void *(*)(void *, std::size_t, int, int, int, long);                                              \
    static auto const original = reinterpret_cast<Function>(dlsym(RTLD_NEXT, #symbol));                                \
    if ((protection & PROT_WRITE) != 0) symreal::memory::note_mapped_memory();                                         \
    return original(at, size, protection, flags, file, offset);                                                        \
  }
MAPPING(mmap)
MAPPING(mmap64)
#undef MAPPING

int symreal_mapping_munmap(void *begin, std::size_t size) asm("munmap");
[[gnu::weak]] int symreal_mapping_munmap(void *begin, std::size_t size) {
  static auto const original = reinterpret_cast<int (*)(void *, std::size_t)>(dlsym(RTLD_NEXT, "munmap"));
  int const result = original(begin, size);
  if (result == 0 && symreal::detail::recording && !symreal::memory::OwnWork::is_going_on())
    symreal::trace::session().state.released(begin, size);
  return result;
}

void *symreal_mapping_shmat(int segment, void const *at, int flags) asm("shmat");
[[gnu::weak]] void *symreal_mapping_shmat(int segment, void const *at, int flags) {
  static auto const original = reinterpret_cast<void *(*)(int, void const *, int)>(dlsym(RTLD_NEXT, "shmat"));
  symreal::memory::note_mapped_memory();
  return original(segment, at, flags);
}

void *symreal_mapping_sbrk(std::intptr_t more) asm("sbrk");
[[gnu::weak]] void *symreal_mapping_sbrk(std::intptr_t more) {
  static auto const original = reinterpret_cast<void *(*)(std::intptr_t)>(dlsym(RTLD_NEXT, "sbrk"));
  if (more != 0) symreal::memory::note_mapped_memory();
  return original(more);
}

} // extern "C"

#endif
