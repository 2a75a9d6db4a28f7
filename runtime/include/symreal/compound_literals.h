// C's `(T){...}` is an object that lives as long as the block around it. Here it lives as long as the call of the
// function around it, or, outside of functions, as the program. Each literal of the
// source has its own object, which every evaluation reuses.
#pragma once

#include <cstddef>
#include <cstring>
#include <new>
#include <type_traits>

namespace symreal {
namespace detail {

template <class Site> inline char const site = 0; // its address identifies the literal

template <class T> T &placed(void *where, T const &value) noexcept {
  static_assert(std::is_trivially_copyable_v<T>);
  std::memcpy(where, &value, sizeof value);
  return *std::launder(static_cast<T *>(where));
}

} // namespace detail

// Storage of one call's compound literals: `bytes` bytes in total, each literal aligned to 16.
template <std::size_t bytes> class SymrealCompoundLiterals {
  static constexpr std::size_t granule = 16;

  alignas(granule) unsigned char storage_[bytes];
  struct {
    void const *site;
    std::size_t at;
  } known_[bytes / granule];
  std::size_t count_ = 0, used_ = 0;

  void *place(void const *site, std::size_t size) noexcept {
    for (std::size_t k = 0; k < count_; ++k)
      if (known_[k].site == site) return storage_ + known_[k].at;
    known_[count_++] = {site, used_};
    used_ += (size + granule - 1) / granule * granule;
    return storage_ + known_[count_ - 1].at;
  }

public:
  SymrealCompoundLiterals() noexcept {} // what is not used stays as it is

  template <class T, class Site> T &symreal_make(T const &value) noexcept {
    return detail::placed<T>(place(&detail::site<Site>, sizeof value), value);
  }
  // `(double[]){...}`
  template <class T, class Site, std::size_t n>
    requires std::is_unbounded_array_v<T>
  auto &symreal_make(std::remove_extent_t<T> const (&values)[n]) noexcept {
    return symreal_make<std::remove_extent_t<T>[n], Site>(values);
  }
};

class SymrealStaticCompoundLiterals {
public:
  template <class T, class Site> T &symreal_make(T const &value) const noexcept {
    alignas(T) static unsigned char storage[sizeof value];
    return detail::placed<T>(storage, value);
  }
  template <class T, class Site, std::size_t n>
    requires std::is_unbounded_array_v<T>
  auto &symreal_make(std::remove_extent_t<T> const (&values)[n]) const noexcept {
    return symreal_make<std::remove_extent_t<T>[n], Site>(values);
  }
};

} // namespace symreal

// Storage for literals outside functions; a function with literals declares its own.
inline constexpr symreal::SymrealStaticCompoundLiterals symreal_literals;
