#include "support/page_allocator.h"

#include <algorithm>
#include <cstdint>
#include <sys/mman.h>

namespace symreal {

// Behind the first of them, huge pages are asked for: there the system's work per page is most of the cost of
// appending. A short array stays in small ones.
static constexpr std::uintptr_t huge_page = std::uintptr_t{1} << 21;

void *map_pages(std::size_t size) {
  void *begin = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (begin == MAP_FAILED) throw std::bad_alloc();
  std::uintptr_t const first = reinterpret_cast<std::uintptr_t>(begin), end = first + size;
  std::uintptr_t const huge = (first + 2 * huge_page - 1) / huge_page * huge_page;
  if (huge < end) madvise(reinterpret_cast<void *>(huge), end - huge, MADV_HUGEPAGE); // advice: no is an answer
  return begin;
}

void unmap_pages(void *begin, std::size_t size) noexcept { munmap(begin, size); }

} // namespace symreal
