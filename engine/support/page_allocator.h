// Allocator of long arrays, with pages directly from the system: `LongArray<Node>`.
//
// A recording reserves address space for its longest array at once, since a growing vector would copy it repeatedly. A
// page uses memory only after its first write. The pages bypass `malloc` and `operator new`, which a program may
// replace and which must not see the longest array.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace symreal {

// mmap of writable zero pages; MAP_FAILED if memory is short. A direct system call, since a symbolic program replaces
// mmap (trace/state/mapping_hooks.cpp).
void *map_anonymous(std::size_t size, int flags);

// Whole zero pages; throws std::bad_alloc if memory is short.
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
  // Default construction leaves the element uninitialised, so that an array can be read into.
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
