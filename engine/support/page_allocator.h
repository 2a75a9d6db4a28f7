// Memory for arrays that grow long, straight from the system: `LongArray<Node>`.
//
// A recording reserves address space for its longest array at once, since a vector that grows would copy it again and
// again. A page takes memory when something is put there. None of it comes from `malloc` or `operator new`: a program
// may bring its own, and the longest array is none of its business.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace symreal {

// mmap of zero pages that can be written; MAP_FAILED where the system has no room. Not by its name, which a symbolic
// program has replaced (trace/state/mapping_hooks.cpp).
void *map_anonymous(std::size_t size, int flags);

// Whole pages, zero; throws std::bad_alloc where the system has no room.
void *map_pages(std::size_t size);
void unmap_pages(void *begin, std::size_t size) noexcept;

template <class T> class PageAllocator {
public:
  using value_type = T;

  PageAllocator() = default;
  template <class U> PageAllocator(PageAllocator<U> const &) {} // NOLINT(google-explicit-constructor): a rebind

  T *allocate(std::size_t count) {
    if (count > least_mapped) return static_cast<T *>(map_pages(count * sizeof(T)));
    return static_cast<T *>(::operator new(count * sizeof(T)));
  }
  void deallocate(T *begin, std::size_t count) noexcept {
    if (count > least_mapped) return unmap_pages(begin, count * sizeof(T));
    ::operator delete(begin);
  }
  // An element without a value is left as it is, so that an array can be read into.
  template <class U> void construct(U *place) { ::new (static_cast<void *>(place)) U; }
  template <class U, class... Arguments> void construct(U *place, Arguments &&...arguments) {
    ::new (static_cast<void *>(place)) U(std::forward<Arguments>(arguments)...);
  }
  friend bool operator==(PageAllocator, PageAllocator) { return true; }

private:
  static constexpr std::size_t least_mapped = (std::size_t{1} << 18) / sizeof(T);
};

template <class T> using LongArray = std::vector<T, PageAllocator<T>>;

} // namespace symreal
