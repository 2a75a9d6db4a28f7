// C's arrays with more than one variable extent: gcc supports them in C++, but a lambda cannot capture one, and
// decisions are lambdas. So this class replaces a pointer to their rows.
#pragma once

#include <cstddef>

namespace symreal {

// `T (*)[m]`, with rank - 1 more extents behind m: `rank` extents, from the outer one in.
template <class T, std::size_t rank> class SymrealVariableRows {
  template <class, std::size_t> friend class SymrealVariableRows;

  T *first_;
  std::ptrdiff_t extents_[rank];

  constexpr std::ptrdiff_t size() const noexcept {
    std::ptrdiff_t product = 1;
    for (std::ptrdiff_t const extent : extents_) product *= extent;
    return product;
  }
  constexpr auto row(std::ptrdiff_t index) const noexcept {
    if constexpr (rank == 1)
      return first_ + index * extents_[0];
    else {
      SymrealVariableRows<T, rank - 1> inner;
      inner.first_ = first_ + index * size();
      for (std::size_t k = 1; k < rank; ++k) inner.extents_[k - 1] = extents_[k];
      return inner;
    }
  }
  constexpr SymrealVariableRows() noexcept = default;

public:
  template <class... Extent> constexpr SymrealVariableRows(void const *first, Extent... extents) noexcept
      : first_(static_cast<T *>(const_cast<void *>(first))),
        extents_{static_cast<std::ptrdiff_t>(extents)...} {
    static_assert(sizeof...(extents) == rank);
  }

  constexpr auto operator[](std::ptrdiff_t index) const noexcept { return row(index); }
  constexpr auto operator*() const noexcept { return row(0); }

  constexpr SymrealVariableRows &operator+=(std::ptrdiff_t count) noexcept {
    first_ += count * size();
    return *this;
  }
  constexpr SymrealVariableRows &operator-=(std::ptrdiff_t count) noexcept { return *this += -count; }
  constexpr SymrealVariableRows &operator++() noexcept { return *this += 1; }
  constexpr SymrealVariableRows operator++(int) noexcept {
    SymrealVariableRows const before = *this;
    *this += 1;
    return before;
  }
  friend constexpr SymrealVariableRows operator+(SymrealVariableRows rows, std::ptrdiff_t count) noexcept {
    return rows += count;
  }
  friend constexpr SymrealVariableRows operator-(SymrealVariableRows rows, std::ptrdiff_t count) noexcept {
    return rows -= count;
  }

  // Conversions for functions that take such an array, and for memset and similar functions.
  constexpr operator void const *() const noexcept { return first_; }
  constexpr operator void *() const noexcept { return const_cast<void *>(static_cast<void const *>(first_)); }
  template <class Other> explicit constexpr operator Other *() const noexcept { return (Other *)(first_); }
  explicit constexpr operator bool() const noexcept { return first_ != nullptr; }
};

} // namespace symreal
