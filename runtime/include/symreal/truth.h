// Truth values as conditions and as numbers: (x > 0) - (x < 0), x * (y > 0), flag & (x > 0).
#pragma once

#include <symreal/decisions.h>

#include <type_traits>

namespace symreal {

// What a condition says, without deciding on it.
[[gnu::always_inline]] inline SymbolicBool truth(SymbolicBool condition) noexcept { return condition; }
[[gnu::always_inline]] inline SymbolicBool truth(RealNumber x) noexcept { return x != RealNumber(0.0); }
template <class T, class = std::enable_if_t<std::is_arithmetic_v<T> || std::is_pointer_v<T>>>
constexpr bool truth(T x) noexcept {
  return static_cast<bool>(x);
}
// The condition that `for (;;)` does not have.
constexpr bool truth() noexcept { return true; }

template <class T> inline constexpr bool is_symbolic_truth =
    std::is_same_v<T, SymbolicBool> || std::is_same_v<T, RealNumber>;

template <class T> inline constexpr bool is_truth = std::is_same_v<T, SymbolicBool> || std::is_same_v<T, bool>;

namespace types {

// An integer made of truth values. It becomes a number without a decision, an integer by one.
class SymbolicInteger {
public:
  template <class T, class = std::enable_if_t<std::is_integral_v<T>>> SymbolicInteger(T value) noexcept
      : value_(value) {}
  SymbolicInteger(SymbolicBool condition) noexcept : value_(condition) {}
  SymbolicInteger(SymbolicInteger const &other) noexcept : value_(other.value_) {} // as that of SymbolicBool
  SymbolicInteger &operator=(SymbolicInteger const &) = default;
  static SymbolicInteger from_number(RealNumber number) noexcept {
    SymbolicInteger result(0);
    result.value_ = number;
    return result;
  }
  RealNumber number() const noexcept { return value_; }
  operator RealNumber() const noexcept { return value_; }
  template <class T, class = std::enable_if_t<std::is_integral_v<T>>>
  [[gnu::always_inline]] operator T() const noexcept {
    return static_cast<T>(value_);
  }

private:
  RealNumber value_;
};

} // namespace types
using types::SymbolicInteger;

inline int value(SymbolicInteger x) noexcept { return static_cast<int>(value(x.number())); }

template <class T> inline constexpr bool is_number_or_truth =
    std::is_arithmetic_v<T> || std::is_same_v<T, RealNumber> || std::is_same_v<T, SymbolicBool> ||
    std::is_same_v<T, SymbolicInteger>;

namespace detail {
template <class T> inline constexpr bool is_symbolic_integer =
    std::is_same_v<T, SymbolicBool> || std::is_same_v<T, SymbolicInteger>;
// One of the two is a truth value or made of them, and the other is that or an ordinary number.
template <class A, class B> inline constexpr bool counts =
    (is_symbolic_integer<A> && (is_symbolic_integer<B> || std::is_arithmetic_v<B>)) ||
    (std::is_arithmetic_v<A> && is_symbolic_integer<B>);
} // namespace detail

namespace types {

#define SYMREAL_COUNT(op)                                                                                              \
  template <class A, class B, class = std::enable_if_t<detail::counts<A, B>>>                                          \
  [[gnu::always_inline]] inline auto operator op(A a, B b) noexcept {                                                  \
    RealNumber const result = RealNumber(a) op RealNumber(b);                                                          \
    if constexpr (std::is_floating_point_v<A> || std::is_floating_point_v<B>)                                          \
      return result;                                                                                                   \
    else                                                                                                               \
      return SymbolicInteger::from_number(result);                                                                     \
  }
SYMREAL_COUNT(+)
SYMREAL_COUNT(-)
SYMREAL_COUNT(*)
#undef SYMREAL_COUNT
template <class A, class = std::enable_if_t<detail::is_symbolic_integer<A>>>
[[gnu::always_inline]] inline SymbolicInteger operator-(A a) noexcept {
  return SymbolicInteger::from_number(-RealNumber(a));
}
// A quotient of integers is cut off, which a quotient of numbers is not: both become ordinary by decisions.
template <class A, class B, class = std::enable_if_t<detail::counts<A, B>>>
[[gnu::always_inline]] inline auto operator/(A a, B b) noexcept {
  if constexpr (std::is_floating_point_v<A> || std::is_floating_point_v<B>)
    return RealNumber(a) / RealNumber(b);
  else
    return static_cast<int>(a) / static_cast<int>(b);
}

// Whether two truth values are the same.
[[gnu::always_inline]] inline SymbolicBool operator!=(SymbolicBool x, SymbolicBool y) noexcept {
  return (x & (!y)) | ((!x) & y);
}
[[gnu::always_inline]] inline SymbolicBool operator==(SymbolicBool x, SymbolicBool y) noexcept { return !(x != y); }

// With an ordinary truth value.
#define SYMREAL_WITH_BOOL(op)                                                                                          \
  template <class T, class = std::enable_if_t<std::is_same_v<T, bool>>>                                                \
  [[gnu::always_inline]] inline SymbolicBool operator op(T x, SymbolicBool y) noexcept {                               \
    return SymbolicBool(x) op y;                                                                                       \
  }                                                                                                                    \
  template <class T, class = std::enable_if_t<std::is_same_v<T, bool>>>                                                \
  [[gnu::always_inline]] inline SymbolicBool operator op(SymbolicBool x, T y) noexcept {                               \
    return x op SymbolicBool(y);                                                                                       \
  }
SYMREAL_WITH_BOOL(&)
SYMREAL_WITH_BOOL(|)
SYMREAL_WITH_BOOL(==)
SYMREAL_WITH_BOOL(!=)
#undef SYMREAL_WITH_BOOL

} // namespace types

} // namespace symreal
