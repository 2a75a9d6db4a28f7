// std::allocator with what C++20, which symbolic mode is, took out of it: for sources before C++20.
#pragma once

#ifdef MBD_SYMBOLIC
#include <symreal/real_number.h>
#endif

#ifdef SYMREAL_BEFORE_CXX20
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>

namespace std {

#ifdef MBD_SYMBOLIC
template <> class allocator<symreal::RealNumber> : public __allocator_base<symreal::RealNumber> {
  using Real = symreal::RealNumber;
#else
template <> class allocator<double> : public __allocator_base<double> {
  using Real = double;
#endif

public:
  using value_type = Real;
  using size_type = size_t;
  using difference_type = ptrdiff_t;
  using pointer = Real *;
  using const_pointer = Real const *;
  using reference = Real &;
  using const_reference = Real const &;
  template <class T> struct rebind {
    using other = allocator<T>;
  };
  using propagate_on_container_move_assignment = true_type;
  using is_always_equal = true_type;

  allocator() = default;
  template <class T> allocator(allocator<T> const &) noexcept {}
  template <class T, class... Arguments> void construct(T *at, Arguments &&...arguments) {
    ::new (static_cast<void *>(at)) T(forward<Arguments>(arguments)...);
  }
  template <class T> void destroy(T *at) { at->~T(); }
  pointer address(reference x) const noexcept { return addressof(x); }
  const_pointer address(const_reference x) const noexcept { return addressof(x); }
  size_type max_size() const noexcept { return size_type(PTRDIFF_MAX) / sizeof(Real); }
  friend bool operator==(allocator const &, allocator const &) noexcept { return true; }
};

} // namespace std
#endif
