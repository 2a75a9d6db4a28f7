// Private copies of read-only data: input pointers of function kernels are rebound to them. Other inputs are annotated
// in place, so that pointers keep their identity, and aliases remain.
#include "engine/support/page_allocator.h"
#include "runtime/memory/heap_blocks.h"
#include "runtime/trace/kernel/kernel.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <sys/mman.h>
#include <unistd.h>
#include <vector>

namespace symreal {

namespace {

struct Copy {
  char *begin;
  std::size_t size;
  char const *original;
};

// Copies live as long as the program: a pointer to one may be anywhere.
std::vector<Copy> &copies() {
  static constinit thread_local std::vector<Copy> *list = nullptr;
  if (!list) list = memory::make_own<std::vector<Copy>>();
  return *list;
}

// Whether the system reports the address as writable; true if unknown.
bool is_writable(void const *address) {
  memory::OwnWork const own;
  std::FILE *file = std::fopen("/proc/self/maps", "r");
  if (!file) return true;
  auto const wanted = reinterpret_cast<std::uintptr_t>(address);
  bool writable = true;
  char line[512];
  while (std::fgets(line, sizeof line, file)) {
    std::uintptr_t begin = 0, end = 0;
    char rights[5] = "";
    if (std::sscanf(line, "%zx-%zx %4s", &begin, &end, rights) != 3 || wanted < begin || wanted >= end) continue;
    writable = rights[1] == 'w';
    break;
  }
  std::fclose(file);
  return writable;
}

// Memory that ends where an inaccessible page begins.
char *guarded_memory(std::size_t size) {
  auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  std::size_t room = (size + page - 1) / page * page;
  void *memory = map_anonymous(room + page, MAP_PRIVATE);
  internal_check(memory != MAP_FAILED);
  mprotect(static_cast<char *>(memory) + room, page, PROT_NONE);
  return static_cast<char *>(memory) + room - size;
}

} // namespace

void *detail::private_copy(void const *pointer, std::size_t low, std::size_t count) noexcept {
  auto *original = static_cast<char const *>(pointer);
  if (!trace::Kernel::current().is_entering_function()) return const_cast<char *>(original);
  bool const is_copy =
      std::any_of(copies().begin(), copies().end(), [original](Copy const &copy) { return copy.begin == original; });
  if (!is_copy && is_writable(original + low)) return const_cast<char *>(original);
  std::size_t size = low + count, kept = 0;
  char const *source = original;
  // A second section of a rebound pointer: elements that the first one annotated move along.
  for (Copy const &copy : copies())
    if (copy.begin == original) {
      if (copy.size >= size) return copy.begin;
      kept = copy.size;
      source = copy.original;
    }
  char *begin = guarded_memory(size);
  std::memcpy(begin, original, kept);
  std::memcpy(begin + kept, source + kept, size - kept);
  copies().push_back({begin, size, source});
  return begin;
}

void const *detail::in_private_copy(void const *pointer) noexcept {
  auto const *at = static_cast<char const *>(pointer);
  if (trace::Kernel::current().is_entering_function())
    for (Copy const &copy : copies())
      if (copy.original <= at && at <= copy.original + copy.size) return copy.begin + (at - copy.original);
  return pointer;
}

} // namespace symreal
