// Truth values as conditions and as numbers: (x > 0) - (x < 0), x * (y > 0), flag & (x > 0).
#pragma once

#include <symreal/decisions.h>
#include <symreal/symbolic_int.h>

#include <type_traits>

namespace symreal {

// The truth value of a condition, without a decision.
[[gnu::always_inline]] inline SymbolicBool symreal_truth(SymbolicBool condition) noexcept { return condition; }
[[gnu::always_inline]] inline SymbolicBool symreal_truth(RealNumber x) noexcept { return x != RealNumber(0.0); }
template <class T, class = std::enable_if_t<std::is_arithmetic_v<T> || std::is_pointer_v<T>>>
constexpr bool symreal_truth(T x) noexcept {
  return static_cast<bool>(x);
}
// The condition that `for (;;)` does not have.
constexpr bool symreal_truth() noexcept { return true; }

// A value that is known by its type from here on, by a handler of exceptions or a std::any: a comparison and an integer
// become what the original has, by a decision where they are symbolic.
inline bool symreal_erased(SymbolicBool value) noexcept { return static_cast<bool>(value); }
template <class T> T symreal_erased(SymbolicInt<T> value) noexcept { return value; }
template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>> constexpr T symreal_erased(T value) noexcept {
  return value;
}
template <class From, class = std::enable_if_t<!std::is_arithmetic_v<std::decay_t<From>>>>
[[gnu::always_inline]] constexpr From &&symreal_erased(From &&value) noexcept {
  return static_cast<From &&>(value);
}

template <class T> inline constexpr bool is_symbolic_truth =
    std::is_same_v<T, SymbolicBool> || std::is_same_v<T, RealNumber>;

template <class T> inline constexpr bool is_truth = std::is_same_v<T, SymbolicBool> || std::is_same_v<T, bool>;

template <class T> inline constexpr bool is_number_or_truth =
    std::is_arithmetic_v<T> || std::is_same_v<T, RealNumber> || std::is_same_v<T, SymbolicBool> ||
    detail::is_symbolic_int<T>;

namespace detail {
// True if one type is a symbolic truth value and the other is one too, an ordinary number or a symbolic integer.
template <class A, class B> inline constexpr bool counts =
    (std::is_same_v<A, SymbolicBool> && (is_number_or_truth<B>)) ||
    (is_number_or_truth<A> && std::is_same_v<B, SymbolicBool>);
// A truth value is an int in arithmetic.
template <class T> [[gnu::always_inline]] inline auto counted(T x) noexcept {
  if constexpr (std::is_same_v<T, SymbolicBool>)
    return SymbolicInt<int>(x);
  else
    return x;
}
} // namespace detail

namespace types {

#define SYMREAL_COUNT(op)                                                                                              \
  template <class A, class B, class = std::enable_if_t<detail::counts<A, B>>>                                          \
  [[gnu::always_inline]] inline auto operator op(A a, B b) noexcept {                                                  \
    return detail::counted(a) op detail::counted(b);                                                                   \
  }
SYMREAL_COUNT(+)
SYMREAL_COUNT(-)
SYMREAL_COUNT(*)
SYMREAL_COUNT(/)
SYMREAL_COUNT(%)
#undef SYMREAL_COUNT
template <class A, class = std::enable_if_t<std::is_same_v<A, SymbolicBool>>>
[[gnu::always_inline]] inline SymbolicInt<int> operator-(A a) noexcept {
  return -SymbolicInt<int>(a);
}

// Equality of two truth values.
[[gnu::always_inline]] inline SymbolicBool operator!=(SymbolicBool x, SymbolicBool y) noexcept {
  return (x & (!y)) | ((!x) & y);
}
[[gnu::always_inline]] inline SymbolicBool operator==(SymbolicBool x, SymbolicBool y) noexcept { return !(x != y); }
// Compares truth values as the integers 0 and 1. Without these overloads a comparison would be ambiguous.
[[gnu::always_inline]] inline SymbolicBool operator<(SymbolicBool x, SymbolicBool y) noexcept { return (!x) & y; }
[[gnu::always_inline]] inline SymbolicBool operator>(SymbolicBool x, SymbolicBool y) noexcept { return x & (!y); }
[[gnu::always_inline]] inline SymbolicBool operator<=(SymbolicBool x, SymbolicBool y) noexcept { return (!x) | y; }
[[gnu::always_inline]] inline SymbolicBool operator>=(SymbolicBool x, SymbolicBool y) noexcept { return x | (!y); }

// Overloads for an ordinary bool operand.
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
