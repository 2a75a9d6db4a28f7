// An integer that was computed from real numbers: the conversion of one, and what integer arithmetic makes of it.
//
// It is recorded as a real number that has integer values, so an index into a table, or a fraction (x/h - i), keeps its
// dependency. Where the program needs an integer of its own (a loop's bound, an index into something that is no table)
// it converts to one, which is a decision. Integers are taken to stay within their types, as signed ones must; what
// would be negative in an unsigned type is a decision.
#pragma once

#include <symreal/extremes.h>
#include <symreal/text.h>

#include <iosfwd>
#include <limits>

namespace symreal {

namespace detail {

template <class T> using IfInteger =
    std::enable_if_t<std::is_integral_v<T> || (std::is_enum_v<T> && std::is_convertible_v<T, int>), int>;
template <class T> using IfFloating = std::enable_if_t<std::is_floating_point_v<T>, int>;
// A type that is not deduced from its argument.
template <class T> struct Given {
  using Type = T;
};
// What the language makes of two integers before it computes.
template <class T, class U> using Common = decltype(T() + U());

template <class T> constexpr Op conversion_to() {
  if constexpr (std::is_signed_v<T>) return sizeof(T) <= 4 ? Op::int32 : Op::int64;
  return sizeof(T) <= 4 ? Op::uint32 : Op::uint64;
}

// The outcome of a decision that goes one way in programs that are not negative where they must not be.
inline void require_not_negative(RealNumber x) noexcept {
  if (x.is_node()) (void)static_cast<bool>(x >= RealNumber(0.0));
}

} // namespace detail

namespace types {

template <class T> class SymbolicInt {
  static_assert(std::is_integral_v<T>);

public:
  SymbolicInt() = default;
  template <class U, detail::IfInteger<U> = 0> constexpr SymbolicInt(U value) noexcept
      : number_(static_cast<double>(static_cast<T>(value))) {}
  // 1 or 0, as for a real number.
  SymbolicInt(SymbolicBool condition) noexcept : number_(condition) {}
  // The conversion of a real number: towards 0.
  [[gnu::always_inline]] explicit SymbolicInt(RealNumber x) noexcept
      : number_(x.is_node() ? detail::record(detail::conversion_to<T>(), x, 0.0, 0.0)
                            : RealNumber(static_cast<double>(static_cast<T>(x.plain())))) {}
  template <class U> SymbolicInt(SymbolicInt<U> other) noexcept : number_(other.number()) {
    if constexpr (std::is_unsigned_v<T> && std::is_signed_v<U>) detail::require_not_negative(number_);
  }
  static SymbolicInt from_number(RealNumber integer) noexcept {
    SymbolicInt result;
    result.number_ = integer;
    return result;
  }

  bool is_symbolic() const noexcept { return number_.is_node(); }
  // As a real number: no decision.
  RealNumber number() const noexcept { return number_; }
  operator RealNumber() const noexcept { return number_; }

  // A decision.
  [[gnu::always_inline]] operator T() const noexcept {
    return static_cast<T>(number_.is_node() ? detail::convert_to_integer(number_) : number_.plain());
  }

  SymbolicInt &operator++() noexcept { return *this = SymbolicInt(*this + T(1)); }
  SymbolicInt &operator--() noexcept { return *this = SymbolicInt(*this - T(1)); }
  SymbolicInt operator++(int) noexcept {
    SymbolicInt old = *this;
    ++*this;
    return old;
  }
  SymbolicInt operator--(int) noexcept {
    SymbolicInt old = *this;
    --*this;
    return old;
  }
  template <class U> SymbolicInt &operator+=(U other) noexcept { return *this = SymbolicInt(*this + other); }
  template <class U> SymbolicInt &operator-=(U other) noexcept { return *this = SymbolicInt(*this - other); }
  template <class U> SymbolicInt &operator*=(U other) noexcept { return *this = SymbolicInt(*this * other); }
  template <class U> SymbolicInt &operator/=(U other) noexcept { return *this = SymbolicInt(*this / other); }
  template <class U> SymbolicInt &operator%=(U other) noexcept { return *this = SymbolicInt(*this % other); }
  // What works on bits works on an integer of the program's own: by decisions.
#define SYMREAL_BITWISE(op)                                                                                            \
  template <class U> SymbolicInt &operator op##=(U other) noexcept {                                                   \
    return *this = SymbolicInt(static_cast<T>(static_cast<T>(*this) op other));                                        \
  }
  SYMREAL_BITWISE(<<)
  SYMREAL_BITWISE(>>)
  SYMREAL_BITWISE(&)
  SYMREAL_BITWISE(|)
  SYMREAL_BITWISE(^)
#undef SYMREAL_BITWISE

private:
  RealNumber number_;
};

} // namespace types

namespace detail {

// Operands after the usual conversions. A negative number would become a large one in an unsigned type.
template <class C, class T> RealNumber as(SymbolicInt<T> x) noexcept { return SymbolicInt<C>(x).number(); }
template <class C, class T, IfInteger<T> = 0> RealNumber as(T x) noexcept {
  return static_cast<double>(static_cast<C>(x));
}

template <class C> SymbolicInt<C> sum(RealNumber x, RealNumber y) { return SymbolicInt<C>::from_number(x + y); }
template <class C> SymbolicInt<C> difference(RealNumber x, RealNumber y) {
  RealNumber const result = x - y;
  if constexpr (std::is_unsigned_v<C>) require_not_negative(result);
  return SymbolicInt<C>::from_number(result);
}
template <class C> SymbolicInt<C> product(RealNumber x, RealNumber y) { return SymbolicInt<C>::from_number(x * y); }
// The quotient of two integers of up to 53 bits, rounded, is never on the other side of an integer.
template <class C> SymbolicInt<C> quotient(RealNumber x, RealNumber y) {
  return SymbolicInt<C>::from_number(trunc(x / y));
}
template <class C> SymbolicInt<C> remainder_of(RealNumber x, RealNumber y) {
  return SymbolicInt<C>::from_number(fmod(x, y));
}

} // namespace detail

namespace types {

// With an integer the result is an integer, with a floating-point number a real number, as in the language.
#define SYMREAL_INTEGER(op, compute)                                                                                   \
  template <class T, class U> SymbolicInt<detail::Common<T, U>> operator op(SymbolicInt<T> x, SymbolicInt<U> y) {      \
    using C = detail::Common<T, U>;                                                                                    \
    return detail::compute<C>(detail::as<C>(x), detail::as<C>(y));                                                     \
  }                                                                                                                    \
  template <class T, class U, detail::IfInteger<U> = 0>                                                                \
  SymbolicInt<detail::Common<T, U>> operator op(SymbolicInt<T> x, U y) {                                               \
    using C = detail::Common<T, U>;                                                                                    \
    return detail::compute<C>(detail::as<C>(x), detail::as<C>(y));                                                     \
  }                                                                                                                    \
  template <class T, class U, detail::IfInteger<T> = 0>                                                                \
  SymbolicInt<detail::Common<T, U>> operator op(T x, SymbolicInt<U> y) {                                               \
    using C = detail::Common<T, U>;                                                                                    \
    return detail::compute<C>(detail::as<C>(x), detail::as<C>(y));                                                     \
  }
SYMREAL_INTEGER(+, sum)
SYMREAL_INTEGER(-, difference)
SYMREAL_INTEGER(*, product)
SYMREAL_INTEGER(/, quotient)
SYMREAL_INTEGER(%, remainder_of)
#undef SYMREAL_INTEGER

#define SYMREAL_MIXED(op)                                                                                              \
  template <class T, class U, detail::IfFloating<U> = 0> RealNumber operator op(SymbolicInt<T> x, U y) {               \
    return x.number() op RealNumber(y);                                                                                \
  }                                                                                                                    \
  template <class T, class U, detail::IfFloating<T> = 0> RealNumber operator op(T x, SymbolicInt<U> y) {               \
    return RealNumber(x) op y.number();                                                                                \
  }
SYMREAL_MIXED(+)
SYMREAL_MIXED(-)
SYMREAL_MIXED(*)
SYMREAL_MIXED(/)
#undef SYMREAL_MIXED

#define SYMREAL_INTEGER_COMPARISON(op)                                                                                 \
  template <class T, class U> SymbolicBool operator op(SymbolicInt<T> x, SymbolicInt<U> y) {                           \
    using C = detail::Common<T, U>;                                                                                    \
    return detail::as<C>(x) op detail::as<C>(y);                                                                       \
  }                                                                                                                    \
  template <class T, class U, detail::IfInteger<U> = 0> SymbolicBool operator op(SymbolicInt<T> x, U y) {              \
    using C = detail::Common<T, U>;                                                                                    \
    return detail::as<C>(x) op detail::as<C>(y);                                                                       \
  }                                                                                                                    \
  template <class T, class U, detail::IfInteger<T> = 0> SymbolicBool operator op(T x, SymbolicInt<U> y) {              \
    using C = detail::Common<T, U>;                                                                                    \
    return detail::as<C>(x) op detail::as<C>(y);                                                                       \
  }                                                                                                                    \
  template <class T, class U, detail::IfFloating<U> = 0> SymbolicBool operator op(SymbolicInt<T> x, U y) {             \
    return x.number() op RealNumber(y);                                                                                \
  }                                                                                                                    \
  template <class T, class U, detail::IfFloating<T> = 0> SymbolicBool operator op(T x, SymbolicInt<U> y) {             \
    return RealNumber(x) op y.number();                                                                                \
  }
SYMREAL_INTEGER_COMPARISON(<)
SYMREAL_INTEGER_COMPARISON(<=)
SYMREAL_INTEGER_COMPARISON(>)
SYMREAL_INTEGER_COMPARISON(>=)
SYMREAL_INTEGER_COMPARISON(==)
SYMREAL_INTEGER_COMPARISON(!=)
#undef SYMREAL_INTEGER_COMPARISON

template <class T> SymbolicInt<detail::Common<T, T>> operator-(SymbolicInt<T> x) noexcept { return T(0) - x; }
template <class T> SymbolicInt<detail::Common<T, T>> operator+(SymbolicInt<T> x) noexcept { return T(0) + x; }

} // namespace types

template <class T> SymbolicInt<detail::Common<T, T>> abs(SymbolicInt<T> x) noexcept {
  return SymbolicInt<detail::Common<T, T>>::from_number(abs(x.number()));
}

inline SymbolicInt<long> lround(RealNumber x) noexcept { return SymbolicInt<long>(round(x)); }
inline SymbolicInt<long long> llround(RealNumber x) noexcept { return SymbolicInt<long long>(round(x)); }
inline SymbolicInt<long> lrint(RealNumber x) noexcept { return SymbolicInt<long>(rint(x)); }
inline SymbolicInt<long long> llrint(RealNumber x) noexcept { return SymbolicInt<long long>(rint(x)); }

// y where the condition holds, else z; both are computed.
template <class T, class U>
SymbolicInt<std::common_type_t<T, U>> select(SymbolicBool condition, SymbolicInt<T> y, SymbolicInt<U> z) noexcept {
  return SymbolicInt<std::common_type_t<T, U>>::from_number(select(condition, y.number(), z.number()));
}

// As for real numbers, the template of <algorithm>: (y < x) ? y : x.
#define SYMREAL_EXTREME(name, chosen)                                                                                  \
  template <class T, detail::IfInteger<T> = 0> SymbolicInt<T> name(SymbolicInt<T> x, SymbolicInt<T> y) noexcept {      \
    return chosen;                                                                                                     \
  }                                                                                                                    \
  template <class T, detail::IfInteger<T> = 0>                                                                         \
  SymbolicInt<T> name(SymbolicInt<T> x, typename detail::Given<T>::Type y) noexcept {                                  \
    return name(x, SymbolicInt<T>(y));                                                                                 \
  }                                                                                                                    \
  template <class T, detail::IfInteger<T> = 0>                                                                         \
  SymbolicInt<T> name(typename detail::Given<T>::Type x, SymbolicInt<T> y) noexcept {                                  \
    return name(SymbolicInt<T>(x), y);                                                                                 \
  }
SYMREAL_EXTREME(min, select(y < x, y, x))
SYMREAL_EXTREME(max, select(x < y, y, x))
#undef SYMREAL_EXTREME
template <class T, detail::IfInteger<T> = 0>
SymbolicInt<T> clamp(SymbolicInt<T> x, typename detail::Given<SymbolicInt<T>>::Type low,
                     typename detail::Given<SymbolicInt<T>>::Type high) noexcept {
  return select(x < low, low, select(high < x, high, x));
}

// Prints the carried value; so does REAL_VALUE among the arguments of printf.
template <class T> T value(SymbolicInt<T> x) noexcept { return static_cast<T>(value(x.number())); }
namespace types {
template <class Character, class Traits, class T>
std::basic_ostream<Character, Traits> &operator<<(std::basic_ostream<Character, Traits> &out, SymbolicInt<T> x) {
  if constexpr (std::is_same_v<Character, char>)
    if (x.is_symbolic()) detail::made_stream(out, std::to_string(static_cast<long long>(value(x))), x.number());
  return out << value(x);
}
} // namespace types

} // namespace symreal

using symreal::abs;
namespace std {
using symreal::abs;
using symreal::clamp;
using symreal::max;
using symreal::min;
} // namespace std
