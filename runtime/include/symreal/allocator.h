// std::allocator with the members that C++20, the standard of symbolic mode, removed: for older sources, for numbers
// and symbolic integers.
#pragma once

#ifdef MBD_SYMBOLIC
#include <symreal/real_number.h>
#endif

#ifdef SYMREAL_BEFORE_CXX20
#include <bits/allocator.h> // <memory> has much more
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace symreal {

template <class T> class OlderAllocator : public std::__allocator_base<T> {
public:
  using value_type = T;
  using size_type = std::size_t;
  using difference_type = std::ptrdiff_t;
  using pointer = T *;
  using const_pointer = T const *;
  using reference = T &;
  using const_reference = T const &;
  template <class Other> struct rebind {
    using other = std::allocator<Other>;
  };
  using propagate_on_container_move_assignment = std::true_type;
  using is_always_equal = std::true_type;

  template <class Object, class... Arguments> void construct(Object *at, Arguments &&...arguments) {
    ::new (static_cast<void *>(at)) Object(std::forward<Arguments>(arguments)...);
  }
  template <class Object> void destroy(Object *at) { at->~Object(); }
  pointer address(reference x) const noexcept { return std::addressof(x); }
  const_pointer address(const_reference x) const noexcept { return std::addressof(x); }
  size_type max_size() const noexcept { return size_type(PTRDIFF_MAX) / sizeof(T); }
};

} // namespace symreal

namespace std {

#define SYMREAL_ALLOCATOR(T)                                                                                           \
  template <> class allocator<T> : public symreal::OlderAllocator<T> {                                                 \
  public:                                                                                                              \
    allocator() = default;                                                                                             \
    template <class Other> allocator(allocator<Other> const &) noexcept {}                                             \
    friend bool operator==(allocator const &, allocator const &) noexcept { return true; }                             \
  };
#ifdef MBD_SYMBOLIC
SYMREAL_ALLOCATOR(symreal::RealNumber)
#else
SYMREAL_ALLOCATOR(double)
#endif
SYMREAL_ALLOCATOR(float)
SYMREAL_ALLOCATOR(int)
SYMREAL_ALLOCATOR(unsigned)
SYMREAL_ALLOCATOR(long)
SYMREAL_ALLOCATOR(unsigned long)
#undef SYMREAL_ALLOCATOR

} // namespace std
#endif
