// std::atomic and std::atomic_ref of numbers. The library's own would compare bytes, and the bytes of a symbolic
// value are the name of a node: here an exchange on comparison is a decision on the values.
#pragma once

#include <symreal/real_number.h>
#include <symreal/standard_templates.h>

namespace symreal {

namespace detail {

[[gnu::always_inline]] inline bool is_exchanged(RealNumber stored, RealNumber expected) noexcept {
  if (stored.to_bits() == expected.to_bits()) return true;
  return (stored.is_node() || expected.is_node()) && static_cast<bool>(stored == expected);
}

// Common base of both. `Self` provides the address.
template <class Self> class AtomicNumber {
public:
  using value_type = RealNumber;
  using difference_type = RealNumber;
  static constexpr bool is_always_lock_free = __atomic_always_lock_free(sizeof(RealNumber), nullptr);

  bool is_lock_free() const noexcept { return is_always_lock_free; }
  RealNumber load(std::memory_order = {}) const noexcept {
    RealNumber value(0.0);
    __atomic_load(address(), &value, __ATOMIC_SEQ_CST);
    return value;
  }
  operator RealNumber() const noexcept { return load(); }
  void store(RealNumber value, std::memory_order = {}) const noexcept {
    __atomic_store(address(), &value, __ATOMIC_SEQ_CST);
  }
  RealNumber exchange(RealNumber value, std::memory_order = {}) const noexcept {
    RealNumber old(0.0);
    __atomic_exchange(address(), &value, &old, __ATOMIC_SEQ_CST);
    return old;
  }
  [[gnu::always_inline]] bool compare_exchange_strong(RealNumber &expected, RealNumber value, std::memory_order = {},
                                                      std::memory_order = {}) const noexcept {
    RealNumber stored = load();
    do
      if (!is_exchanged(stored, expected)) {
        expected = stored;
        return false;
      }
    while (!replace(stored, value));
    return true;
  }
  [[gnu::always_inline]] bool compare_exchange_weak(RealNumber &expected, RealNumber value, std::memory_order = {},
                                                    std::memory_order = {}) const noexcept {
    return compare_exchange_strong(expected, value);
  }
  [[gnu::always_inline]] RealNumber fetch_add(RealNumber value, std::memory_order = {}) const noexcept {
    RealNumber stored = load();
    while (!replace(stored, stored + value)) {
    }
    return stored;
  }
  [[gnu::always_inline]] RealNumber fetch_sub(RealNumber value, std::memory_order = {}) const noexcept {
    RealNumber stored = load();
    while (!replace(stored, stored - value)) {
    }
    return stored;
  }
  [[gnu::always_inline]] RealNumber operator+=(RealNumber value) const noexcept { return fetch_add(value) + value; }
  [[gnu::always_inline]] RealNumber operator-=(RealNumber value) const noexcept { return fetch_sub(value) - value; }

private:
  RealNumber *address() const noexcept { return static_cast<Self const *>(this)->address_of_number(); }
  // Compare-exchange by bytes; on failure `stored` receives the current number.
  bool replace(RealNumber &stored, RealNumber value) const noexcept {
    return __atomic_compare_exchange(address(), &stored, &value, false, __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST);
  }
};

} // namespace detail
} // namespace symreal

template <> struct std::atomic<symreal::RealNumber> : symreal::detail::AtomicNumber<std::atomic<symreal::RealNumber>> {
  constexpr atomic() noexcept : number_(0.0) {}
  constexpr atomic(symreal::RealNumber value) noexcept : number_(value) {}
  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T> && !std::is_same_v<T, symreal::RealNumber>>>
  constexpr atomic(T value) noexcept : number_(value) {}
  atomic(atomic const &) = delete;
  atomic &operator=(atomic const &) = delete;
  symreal::RealNumber operator=(symreal::RealNumber value) noexcept {
    store(value);
    return value;
  }
  symreal::RealNumber *address_of_number() const noexcept { return &number_; }
  template <class Numbers> void symreal_members(Numbers &numbers) const { numbers.visit(number_); }

private:
  mutable symreal::RealNumber number_;
};

template <> struct std::atomic_ref<symreal::RealNumber>
    : symreal::detail::AtomicNumber<std::atomic_ref<symreal::RealNumber>> {
  static constexpr std::size_t required_alignment = alignof(symreal::RealNumber);
  explicit atomic_ref(symreal::RealNumber &number) noexcept : number_(&number) {}
  atomic_ref(atomic_ref const &) noexcept = default;
  atomic_ref &operator=(atomic_ref const &) = delete;
  symreal::RealNumber operator=(symreal::RealNumber value) const noexcept {
    store(value);
    return value;
  }
  symreal::RealNumber *address_of_number() const noexcept { return number_; }

private:
  symreal::RealNumber *number_;
};
