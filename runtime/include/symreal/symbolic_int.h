// SymbolicInt: an integer computed from real numbers, by a conversion or by arithmetic on such integers.
//
// It is recorded as a real number that has integer values, so an index into a table, or a fraction (x/h - i), keeps its
// dependency; one of 64 bits as integer64.h says. It has the values that the host's compiler gives it: conversions, the
// promotions and usual conversions of the language, unsigned types that wrap. If a signed type of 32 bits overflows
// the original is undefined, and the graph says so to verification. If the program needs an integer of its own (a
// loop bound, an index into an array without a table) it converts to one, which is a decision.
#pragma once

#include <symreal/integer64.h>

#include <iosfwd>
#include <limits>

namespace symreal {

namespace detail {

template <class T> using IfInteger =
    std::enable_if_t<std::is_integral_v<T> || (std::is_enum_v<T> && std::is_convertible_v<T, int>), int>;
template <class T> using IfFloating = std::enable_if_t<std::is_floating_point_v<T>, int>;
// A type in a non-deduced context.
template <class T> struct Given {
  using Type = T;
};
// Result types of the usual arithmetic conversions and of the integral promotion.
template <class T, class U> using Common = decltype(T() + U());
template <class T> using Promoted = decltype(+T());

template <class T> inline constexpr bool is_wide = sizeof(T) > 4;
template <class T> inline constexpr double bound_of_type = sizeof(T) == 1 ? 0x1p8 : sizeof(T) == 2 ? 0x1p16 : 0x1p32;
template <class T, class U>
inline constexpr bool holds_all_of = sizeof(T) > sizeof(U)
                                         ? std::is_signed_v<T> || std::is_unsigned_v<U>
                                         : sizeof(T) == sizeof(U) && std::is_signed_v<T> == std::is_signed_v<U>;

template <class T> constexpr Op wrap_to() {
  if constexpr (std::is_signed_v<T>)
    return sizeof(T) == 1 ? Op::wrap_int8 : sizeof(T) == 2 ? Op::wrap_int16 : Op::wrap_int32;
  return sizeof(T) == 1 ? Op::wrap_uint8 : sizeof(T) == 2 ? Op::wrap_uint16 : Op::wrap_uint32;
}
// The low bits of an integral number, as a type of up to 32 bits.
template <class T> [[gnu::always_inline]] inline RealNumber wrapped(RealNumber x) noexcept {
  if (x.is_node()) return record(wrap_to<T>(), x, 0.0, 0.0);
  return static_cast<double>(static_cast<T>(static_cast<std::int64_t>(x.plain())));
}
// The result of arithmetic that the type holds wherever the original is defined.
template <class T> [[gnu::always_inline]] inline RealNumber within(RealNumber x) noexcept {
  return x.is_node() ? record(std::is_signed_v<T> ? Op::within_int32 : Op::within_uint32, x, 0.0, 0.0) : x;
}
// The carried value of an integer of 64 bits, by a decision.
[[gnu::noinline]] std::uint64_t convert_wide(RealNumber bits) noexcept;

template <class T> using Held = std::conditional_t<is_wide<T>, Integer64, RealNumber>;

// The conversion of a real number: the language's for a plain one; for a node towards 0, as gcc does it.
template <class T> [[gnu::always_inline]] inline Held<T> converted(RealNumber x) noexcept {
  if constexpr (is_wide<T>) {
    if (!x.is_node()) return integer64(static_cast<std::uint64_t>(static_cast<T>(x.plain())));
    if constexpr (std::is_signed_v<T>) return {record(Op::int64, x, 0.0, 0.0), 0, 0x1p63};
    return integer64_of_bits(record(Op::wide_uint, x, 0.0, 0.0));
  } else {
    if (!x.is_node()) return static_cast<double>(static_cast<T>(x.plain()));
    if constexpr (std::is_unsigned_v<T> && sizeof(T) == 4) return wrapped<T>(record(Op::int64, x, 0.0, 0.0));
    RealNumber const number = record(Op::int32, x, 0.0, 0.0);
    return sizeof(T) == 4 ? number : wrapped<T>(number);
  }
}

// An integer of type U as one of type T.
template <class T, class U> [[gnu::always_inline]] inline Held<T> cast(Held<U> x) noexcept {
  if constexpr (is_wide<T> && is_wide<U>) {
    bool const may_change = std::is_unsigned_v<T> && std::is_signed_v<U>;
    return may_change && x.is_node() ? integer64_of_bits(bits_of(x)) : x;
  } else if constexpr (is_wide<T>) {
    if (!x.is_node()) return integer64(static_cast<std::uint64_t>(static_cast<U>(x.plain())));
    Integer64 const exact = integer64_of_number(x, bound_of_type<U>);
    return holds_all_of<T, U> ? exact : integer64_of_bits(bits_of(exact));
  } else if constexpr (is_wide<U>) {
    if (!x.is_node()) return static_cast<double>(static_cast<T>(x.plain));
    if (x.bound == 0) {
      RealNumber const low = record(Op::wide_low, x.number, 0.0, 0.0);
      return wrap_to<T>() == Op::wrap_uint32 ? low : wrapped<T>(low);
    }
    bool const fits =
        x.bound <= static_cast<double>(std::numeric_limits<T>::max()) && (std::is_signed_v<T> || std::is_unsigned_v<U>);
    return fits ? x.number : wrapped<T>(x.number);
  } else {
    return holds_all_of<T, U> ? x : wrapped<T>(x);
  }
}

} // namespace detail

namespace types {

template <class T> class SymbolicInt {
  static_assert(std::is_integral_v<T>);

public:
  SymbolicInt() = default;
  template <class U, detail::IfInteger<U> = 0> constexpr SymbolicInt(U value) noexcept
      : held_(from_plain(static_cast<T>(value))) {}
  // 1 or 0, as for a real number.
  SymbolicInt(SymbolicBool condition) noexcept : held_(from_small(RealNumber(condition), 1)) {}
  constexpr SymbolicInt(double value) noexcept : held_(from_plain(static_cast<T>(value))) {}
  // The conversion of a real number.
  [[gnu::always_inline]] explicit SymbolicInt(RealNumber x) noexcept : held_(detail::converted<T>(x)) {}
  template <class U> [[gnu::always_inline]] SymbolicInt(SymbolicInt<U> other) noexcept
      : held_(detail::cast<T, U>(other.held())) {}
  static constexpr SymbolicInt from_held(detail::Held<T> held) noexcept {
    SymbolicInt result(T(0));
    result.held_ = held;
    return result;
  }
  // The integer of a number into which other code converted an integer of this type.
  static SymbolicInt from_number(RealNumber integer) noexcept {
    if (detail::is_wide<T> && integer.is_node()) integer = detail::record(Op::within_double, integer, 0.0, 0.0);
    return from_held(from_small(integer, detail::largest_exact));
  }

  bool is_symbolic() const noexcept { return held_.is_node(); }
  // The integer as a real number: no decision.
  [[gnu::always_inline]] RealNumber number() const noexcept {
    if constexpr (detail::is_wide<T>)
      return detail::real_of<T>(held_);
    else
      return held_;
  }
  [[gnu::always_inline]] operator RealNumber() const noexcept { return number(); }
  detail::Held<T> held() const noexcept { return held_; }
  // The plain value. Requires !is_symbolic().
  T plain() const noexcept {
    if constexpr (detail::is_wide<T>)
      return static_cast<T>(held_.plain);
    else
      return static_cast<T>(held_.plain());
  }

  // A decision.
  [[gnu::always_inline]] operator T() const noexcept {
    if (!is_symbolic()) return plain();
    if constexpr (detail::is_wide<T>)
      if (held_.bound == 0) return static_cast<T>(detail::convert_wide(held_.number));
    return static_cast<T>(detail::convert_to_integer(number()));
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
#define SYMREAL_ASSIGNMENT(op)                                                                                         \
  template <class U> SymbolicInt &operator op##=(U other) noexcept { return *this = SymbolicInt(*this op other); }
  SYMREAL_ASSIGNMENT(+)
  SYMREAL_ASSIGNMENT(-)
  SYMREAL_ASSIGNMENT(*)
  SYMREAL_ASSIGNMENT(/)
  SYMREAL_ASSIGNMENT(%)
  SYMREAL_ASSIGNMENT(<<)
  SYMREAL_ASSIGNMENT(>>)
  SYMREAL_ASSIGNMENT(&)
  SYMREAL_ASSIGNMENT(|)
  SYMREAL_ASSIGNMENT(^)
#undef SYMREAL_ASSIGNMENT

private:
  static constexpr detail::Held<T> from_plain(T value) noexcept {
    if constexpr (detail::is_wide<T>)
      return detail::integer64(static_cast<std::uint64_t>(value));
    else
      return static_cast<double>(value);
  }
  static detail::Held<T> from_small(RealNumber number, double bound) noexcept {
    if constexpr (detail::is_wide<T>)
      return detail::integer64_of_number(number, bound);
    else
      return number;
  }

  detail::Held<T> held_;
};

} // namespace types
} // namespace symreal

#include <symreal/symbolic_int_operators.h>
