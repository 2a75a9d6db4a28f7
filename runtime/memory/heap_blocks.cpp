#include "runtime/memory/heap_blocks.h"

#include <atomic>
#include <functional>
#include <link.h>
#include <map>
#include <mutex>
#include <new>

#ifdef __GLIBC__
extern "C" {
void *__libc_malloc(std::size_t size);
void __libc_free(void *block);
}
#else
#include <cstdlib>
#define __libc_malloc std::malloc
#define __libc_free std::free
#endif

namespace symreal::memory {

__thread int OwnWork::depth_ = 0;
void (*OwnWork::at_end_)() = nullptr;

namespace {

// Takes memory from where the hooks do not see it: they call this table.
template <class T> struct Unseen {
  using value_type = T;
  Unseen() = default;
  template <class U> Unseen(Unseen<U> const &) {}
  T *allocate(std::size_t count) {
    void *memory = __libc_malloc(count * sizeof(T));
    if (!memory) throw std::bad_alloc();
    return static_cast<T *>(memory);
  }
  void deallocate(T *memory, std::size_t) { __libc_free(memory); }
  bool operator==(Unseen const &) const { return true; }
};

struct Entry {
  std::size_t size;
  std::uint64_t serial;
  void const *caller;
};
using Table = std::map<void *, Entry, std::less<>, Unseen<std::pair<void *const, Entry>>>;

constinit std::mutex mutex;
std::uint64_t last_serial = 0;
std::atomic<bool> is_mapped = false;

// Made on first use, never destroyed: the program allocates before and after main.
Table &table() {
  alignas(Table) static std::byte memory[sizeof(Table)];
  static Table *made = nullptr;
  if (!made) made = new (memory) Table;
  return *made;
}

// The code of the C library.
struct Code {
  std::uintptr_t begin = 0, end = 0;
  bool contains(void const *address) const {
    auto const at = reinterpret_cast<std::uintptr_t>(address);
    return begin <= at && at < end;
  }
};

Code code_of_c_library() {
  Code found;
  dl_iterate_phdr(
      [](dl_phdr_info *object, std::size_t, void *result) {
        for (int i = 0; i < object->dlpi_phnum; ++i) {
          auto const &part = object->dlpi_phdr[i];
          std::uintptr_t const begin = object->dlpi_addr + part.p_vaddr;
          Code const code{begin, begin + part.p_memsz};
          if (part.p_type == PT_LOAD && code.contains(reinterpret_cast<void const *>(&__libc_malloc)))
            *static_cast<Code *>(result) = code;
        }
        return 0;
      },
      &found);
  return found;
}

} // namespace

void note_allocated(void *block, std::size_t size, void const *caller) {
  if (!block || OwnWork::is_going_on()) return;
  std::scoped_lock const lock(mutex);
  table()[block] = {size, ++last_serial, caller};
}

void note_released(void *block) {
  std::scoped_lock const lock(mutex);
  table().erase(block);
}

std::vector<HeapBlock> heap_blocks() {
  OwnWork const own;
  static Code const c_library = code_of_c_library();
  std::vector<HeapBlock, Unseen<HeapBlock>> blocks; // the hooks wait for the lock
  {
    std::scoped_lock const lock(mutex);
    for (auto const &[begin, entry] : table())
      if (!c_library.contains(entry.caller)) blocks.push_back({static_cast<char *>(begin), entry.size, entry.serial});
  }
  return {blocks.begin(), blocks.end()};
}

bool has_mapped_memory() { return is_mapped; }
void note_mapped_memory() { is_mapped = true; }

} // namespace symreal::memory
