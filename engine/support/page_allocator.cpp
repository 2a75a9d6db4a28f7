#include "engine/support/page_allocator.h"

#include <algorithm>
#include <cstdint>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace symreal {

// Beyond the first 2 MiB, huge pages are requested: there the system's work per page dominates the cost of appending.
// Short arrays stay in small pages.
static constexpr std::uintptr_t huge_page = std::uintptr_t{1} << 21;

void *map_anonymous(std::size_t size, int flags) {
  long const begin = syscall(SYS_mmap, nullptr, size, PROT_READ | PROT_WRITE, flags | MAP_ANONYMOUS, -1, 0L);
  return begin == -1 ? MAP_FAILED : reinterpret_cast<void *>(begin);
}

void *map_pages(std::size_t size) {
  void *begin = map_anonymous(size, MAP_PRIVATE | MAP_NORESERVE);
  if (begin == MAP_FAILED) throw std::bad_alloc();
  std::uintptr_t const first = reinterpret_cast<std::uintptr_t>(begin), end = first + size;
  std::uintptr_t const huge = (first + 2 * huge_page - 1) / huge_page * huge_page;
  if (huge < end) madvise(reinterpret_cast<void *>(huge), end - huge, MADV_HUGEPAGE); // a hint, which may be refused
  return begin;
}

void unmap_pages(void *begin, std::size_t size) noexcept { munmap(begin, size); }

} // namespace symreal
