// Allocation of long blocks in huge pages, if the system has them: clearing a 4 KB page on first touch costs more than
// a pass spends on that memory. Recorded programs keep their own `new`.
#include <cstdint>
#include <cstdlib>
#include <new>
#include <sys/mman.h>

// The sanitizers define these functions themselves.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

static constexpr std::size_t huge_page = std::size_t{1} << 21;

static void *allocated(std::size_t size) {
  void *const block = std::malloc(size);
  if (block == nullptr || size < 2 * huge_page) return block;
  std::uintptr_t const first = reinterpret_cast<std::uintptr_t>(block);
  std::uintptr_t const begin = (first + huge_page - 1) / huge_page * huge_page,
                       end = (first + size) / huge_page * huge_page;
  madvise(reinterpret_cast<void *>(begin), end - begin, MADV_HUGEPAGE); // only advice: failure is harmless
  return block;
}

void *operator new(std::size_t size) {
  while (true) {
    if (void *const block = allocated(size == 0 ? 1 : size)) return block;
    std::new_handler const handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void operator delete(void *block) noexcept { std::free(block); }

void operator delete(void *block, std::size_t /*size*/) noexcept { std::free(block); }

#endif
