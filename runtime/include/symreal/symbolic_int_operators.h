// Arithmetic of SymbolicInt. With an integer the result is an integer of the type that the language gives it, with a
// floating-point number a real number.
#pragma once

#include <symreal/symbolic_int.h>
#include <symreal/text.h>

namespace symreal {

namespace detail {

// Arithmetic in type C, with at least one symbolic operand. 32-bit sums are exact as real numbers; so is a signed
// product within its type, but not every unsigned product. A zero result must not be -0.
template <class C> [[gnu::always_inline]] inline RealNumber sum(RealNumber x, RealNumber y) noexcept {
  return std::is_signed_v<C> ? within<C>(x + y) : wrapped<C>(x + y);
}
template <class C> [[gnu::always_inline]] inline RealNumber difference(RealNumber x, RealNumber y) noexcept {
  if (std::is_signed_v<C> && is_zero(x)) return within<C>(negative(y));
  return std::is_signed_v<C> ? within<C>(x - y) : wrapped<C>(x - y);
}
template <class C> [[gnu::always_inline]] inline RealNumber product(RealNumber x, RealNumber y) noexcept {
  return std::is_signed_v<C> ? within<C>(x * y + RealNumber(0.0)) : record(Op::mul_uint32, x, y, 0.0);
}
template <class C> [[gnu::always_inline]] inline RealNumber quotient(RealNumber x, RealNumber y) noexcept {
  return within<C>(divided(x, y));
}
template <class C> [[gnu::always_inline]] inline RealNumber remainder_of(RealNumber x, RealNumber y) noexcept {
  return within<C>(fmod(x, y) + RealNumber(0.0));
}
#define SYMREAL_COMPARE(name, op)                                                                                      \
  template <class C> [[gnu::always_inline]] inline SymbolicBool name(RealNumber x, RealNumber y) noexcept {            \
    return x op y;                                                                                                     \
  }
SYMREAL_COMPARE(less, <)
SYMREAL_COMPARE(less_or_equal, <=)
SYMREAL_COMPARE(greater, >)
SYMREAL_COMPARE(greater_or_equal, >=)
SYMREAL_COMPARE(equal, ==)
SYMREAL_COMPARE(not_equal, !=)
#undef SYMREAL_COMPARE

// A bitwise operation, of the bits that 64 have.
template <class C> [[gnu::always_inline]] inline SymbolicInt<C> bitwise(Op op, Integer64 x, Integer64 y) noexcept {
  return SymbolicInt<C>::from_held(cast<C, std::uint64_t>(wide(op, x, y)));
}
template <class C> [[gnu::always_inline]] inline Integer64 widened(SymbolicInt<C> x) noexcept {
  return cast<std::int64_t, C>(x.held());
}

// Arithmetic of a float is rounded to one.
template <class U> [[gnu::always_inline]] inline RealNumber rounded(RealNumber x) noexcept {
  if constexpr (!std::is_same_v<U, float>) return x;
  if (x.is_node()) return record(Op::f32, x, 0.0, 0.0);
  return static_cast<double>(static_cast<float>(x.plain()));
}

template <class T> using IfSymbolic = std::enable_if_t<is_symbolic_int<T>, int>;
template <class T> using IfTruth = std::enable_if_t<std::is_same_v<T, SymbolicBool>, int>;

} // namespace detail

namespace types {

// Has the program an operator of its own for the two, of which one is an enumeration?
#define SYMREAL_OVERLOADED(op, T, U)                                                                                   \
  (std::is_enum_v<T> || std::is_enum_v<U>) && requires(T a, U b) { operator op(a, b); }

// Each operator for a symbolic integer and another one, on either side.
#define SYMREAL_INTEGERS(op, result, ...)                                                                              \
  template <class T, class U> [[gnu::always_inline]] inline result operator op(SymbolicInt<T> x, SymbolicInt<U> y) {   \
    __VA_ARGS__                                                                                                        \
  }                                                                                                                    \
  template <class T, class U, detail::IfInteger<U> = 0>                                                                \
    requires(!(SYMREAL_OVERLOADED(op, T, U)))                                                                          \
  [[gnu::always_inline]] inline result operator op(SymbolicInt<T> x, U y) {                                            \
    __VA_ARGS__                                                                                                        \
  }                                                                                                                    \
  template <class T, class U, detail::IfInteger<T> = 0>                                                                \
    requires(!(SYMREAL_OVERLOADED(op, T, U)))                                                                          \
  [[gnu::always_inline]] inline result operator op(T x, SymbolicInt<U> y) {                                            \
    __VA_ARGS__                                                                                                        \
  }
#define SYMREAL_COMMON(T, U) SymbolicInt<detail::Common<T, U>>
#define SYMREAL_PROMOTED(T, U) SymbolicInt<detail::Promoted<T>>
#define SYMREAL_TRUTH(T, U) SymbolicBool

#define SYMREAL_ARITHMETIC(op, name)                                                                                   \
  SYMREAL_INTEGERS(op, SYMREAL_COMMON(T, U), using C = detail::Common<T, U>; SymbolicInt<C> const a(x), b(y);          \
                   if (!a.is_symbolic() && !b.is_symbolic()) return SymbolicInt<C>(a.plain() op b.plain());            \
                   return SymbolicInt<C>::from_held(detail::name<C>(a.held(), b.held()));)
SYMREAL_ARITHMETIC(+, sum)
SYMREAL_ARITHMETIC(-, difference)
SYMREAL_ARITHMETIC(*, product)
SYMREAL_ARITHMETIC(/, quotient)
SYMREAL_ARITHMETIC(%, remainder_of)
#undef SYMREAL_ARITHMETIC

#define SYMREAL_BITWISE(op, id)                                                                                        \
  SYMREAL_INTEGERS(op, SYMREAL_COMMON(T, U), using C = detail::Common<T, U>; SymbolicInt<C> const a(x), b(y);          \
                   if (!a.is_symbolic() && !b.is_symbolic()) return SymbolicInt<C>(a.plain() op b.plain());            \
                   return detail::bitwise<C>(Op::id, detail::widened(a), detail::widened(b));)
SYMREAL_BITWISE(&, wide_and)
SYMREAL_BITWISE(|, wide_or)
SYMREAL_BITWISE(^, wide_xor)
#undef SYMREAL_BITWISE

// Each operand of a shift is promoted by itself.
#define SYMREAL_SHIFT(op, id)                                                                                          \
  SYMREAL_INTEGERS(op, SYMREAL_PROMOTED(T, U), using C = detail::Promoted<T>; using D = detail::Promoted<U>;           \
                   SymbolicInt<C> const a(x); SymbolicInt<D> const b(y);                                               \
                   if (!a.is_symbolic() && !b.is_symbolic()) return SymbolicInt<C>(a.plain() op b.plain());            \
                   return detail::bitwise<C>(id, detail::widened(a), detail::widened(b));)
SYMREAL_SHIFT(<<, Op::wide_shl)
SYMREAL_SHIFT(>>, std::is_signed_v<C> ? Op::wide_shr : Op::wide_ushr)
#undef SYMREAL_SHIFT

#define SYMREAL_COMPARISON(op, name)                                                                                   \
  SYMREAL_INTEGERS(op, SYMREAL_TRUTH(T, U), using C = detail::Common<T, U>; SymbolicInt<C> const a(x), b(y);           \
                   if (!a.is_symbolic() && !b.is_symbolic()) return SymbolicBool(a.plain() op b.plain());              \
                   return detail::name<C>(a.held(), b.held());)                                                        \
  template <class T, class U, detail::IfFloating<U> = 0> SymbolicBool operator op(SymbolicInt<T> x, U y) {             \
    return detail::rounded<U>(x.number()) op RealNumber(y);                                                            \
  }                                                                                                                    \
  template <class T, class U, detail::IfFloating<T> = 0> SymbolicBool operator op(T x, SymbolicInt<U> y) {             \
    return RealNumber(x) op detail::rounded<T>(y.number());                                                            \
  }                                                                                                                    \
  template <class T> SymbolicBool operator op(SymbolicInt<T> x, SymbolicBool y) { return x op SymbolicInt<int>(y); }   \
  template <class T> SymbolicBool operator op(SymbolicBool x, SymbolicInt<T> y) { return SymbolicInt<int>(x) op y; }
SYMREAL_COMPARISON(<, less)
SYMREAL_COMPARISON(<=, less_or_equal)
SYMREAL_COMPARISON(>, greater)
SYMREAL_COMPARISON(>=, greater_or_equal)
SYMREAL_COMPARISON(==, equal)
SYMREAL_COMPARISON(!=, not_equal)
#undef SYMREAL_COMPARISON
#undef SYMREAL_TRUTH
#undef SYMREAL_PROMOTED
#undef SYMREAL_COMMON
#undef SYMREAL_INTEGERS
#undef SYMREAL_OVERLOADED

#define SYMREAL_MIXED(op)                                                                                              \
  template <class T, class U, detail::IfFloating<U> = 0> RealNumber operator op(SymbolicInt<T> x, U y) {               \
    return detail::rounded<U>(detail::rounded<U>(x.number()) op RealNumber(y));                                        \
  }                                                                                                                    \
  template <class T, class U, detail::IfFloating<T> = 0> RealNumber operator op(T x, SymbolicInt<U> y) {               \
    return detail::rounded<T>(RealNumber(x) op detail::rounded<T>(y.number()));                                        \
  }
SYMREAL_MIXED(+)
SYMREAL_MIXED(-)
SYMREAL_MIXED(*)
SYMREAL_MIXED(/)
#undef SYMREAL_MIXED

template <class T> SymbolicInt<detail::Promoted<T>> operator+(SymbolicInt<T> x) noexcept { return x; }
template <class T> SymbolicInt<detail::Promoted<T>> operator-(SymbolicInt<T> x) noexcept {
  return detail::Promoted<T>(0) - x;
}
template <class T> SymbolicInt<detail::Promoted<T>> operator~(SymbolicInt<T> x) noexcept {
  return static_cast<detail::Promoted<T>>(-1) ^ x;
}

} // namespace types

// y where the condition holds, else z; both are computed.
template <class T, class U> [[gnu::always_inline]] inline SymbolicInt<std::common_type_t<T, U>>
select(SymbolicBool condition, SymbolicInt<T> y, SymbolicInt<U> z) noexcept {
  using C = std::common_type_t<T, U>;
  SymbolicInt<C> const a(y), b(z);
  if constexpr (detail::is_wide<C>)
    return SymbolicInt<C>::from_held(detail::select64<C>(condition, a.held(), b.held()));
  else
    return SymbolicInt<C>::from_held(select(condition, a.held(), b.held()));
}

template <class T> SymbolicInt<detail::Promoted<T>> abs(SymbolicInt<T> x) noexcept {
  using C = detail::Promoted<T>;
  SymbolicInt<C> const y(x);
  if (!y.is_symbolic()) return y.plain() < 0 ? -y.plain() : y.plain();
  if constexpr (!detail::is_wide<C>)
    return SymbolicInt<C>::from_held(detail::within<C>(abs(y.held())));
  else if (y.held().bound != 0)
    return SymbolicInt<C>::from_held(detail::integer64_of_number(abs(y.held().number), y.held().bound));
  else
    return select(y < C(0), -y, y);
}

inline SymbolicInt<int> abs(SymbolicBool x) noexcept { return x; }

inline SymbolicInt<long> lround(RealNumber x) noexcept { return SymbolicInt<long>(round(x)); }
inline SymbolicInt<long long> llround(RealNumber x) noexcept { return SymbolicInt<long long>(round(x)); }
inline SymbolicInt<long> lrint(RealNumber x) noexcept { return SymbolicInt<long>(rint(x)); }
inline SymbolicInt<long long> llrint(RealNumber x) noexcept { return SymbolicInt<long long>(rint(x)); }

namespace detail {
// The lesser of two integers. An unsigned one is bounded by a small constant operand.
template <class T>
[[gnu::always_inline]] inline SymbolicInt<T> lesser(SymbolicBool second, SymbolicInt<T> x, SymbolicInt<T> y) noexcept {
  if constexpr (is_wide<T> && std::is_unsigned_v<T>)
    if (is_small_constant<T>(x.held()) || is_small_constant<T>(y.held())) {
      double const bound = plain_value<T>(is_small_constant<T>(x.held()) ? x.held() : y.held());
      return SymbolicInt<T>::from_held(select_bounded<T>(second, y.held(), x.held(), bound));
    }
  return select(second, y, x);
}
} // namespace detail

// As for real numbers, these compute as the templates of <algorithm>: (y < x) ? y : x.
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
SYMREAL_EXTREME(min, detail::lesser(y < x, x, y))
SYMREAL_EXTREME(max, select(x < y, y, x))
#undef SYMREAL_EXTREME
template <class T, detail::IfInteger<T> = 0>
SymbolicInt<T> clamp(SymbolicInt<T> x, typename detail::Given<SymbolicInt<T>>::Type low,
                     typename detail::Given<SymbolicInt<T>>::Type high) noexcept {
  SymbolicBool const below = x < low, above = high < x;
  if constexpr (detail::is_wide<T>) // between small constants: a real number
    if (detail::is_small_constant<T>(low.held()) && detail::is_small_constant<T>(high.held())) {
      double const bound = std::fmax(detail::bound_of<T>(low.held()), detail::bound_of<T>(high.held()));
      RealNumber const number = select(below, low.number(), select(above, high.number(), x.number()));
      return SymbolicInt<T>::from_held(detail::integer64_of_number(number, bound));
    }
  return select(below, low, select(above, high, x));
}

// Functions of a real number take an integer, too, and a truth value.
#define SYMREAL_CALL_1(id)                                                                                             \
  template <class I, detail::IfSymbolic<I> = 0> RealNumber id(I x) noexcept { return id(RealNumber(x)); }              \
  template <class T, detail::IfTruth<T> = 0> RealNumber id(T x) noexcept { return id(RealNumber(x)); }
#define SYMREAL_CALL_2(id)                                                                                             \
  template <class I, class U, detail::IfSymbolic<I> = 0> RealNumber id(I x, U y) noexcept {                            \
    return id(RealNumber(x), RealNumber(y));                                                                           \
  }                                                                                                                    \
  template <class I, class U, detail::IfSymbolic<I> = 0, std::enable_if_t<!detail::is_symbolic_int<U>, int> = 0>       \
  RealNumber id(U x, I y) noexcept {                                                                                   \
    return id(RealNumber(x), RealNumber(y));                                                                           \
  }
#define SYMREAL_CALL_3(id)
#define MATH_OPERATION(id, arity, evaluate) SYMREAL_CALL_##arity(id)
#include <symreal/math_functions.def>
#undef MATH_OPERATION
SYMREAL_CALL_1(fabs)
SYMREAL_CALL_1(nearbyint)
#undef SYMREAL_CALL_1
#undef SYMREAL_CALL_2
#undef SYMREAL_CALL_3

// Prints the carried value; so does REAL_VALUE among the arguments of printf.
template <class T> T symreal_value(SymbolicInt<T> x) noexcept {
  if (!x.is_symbolic()) return x.plain();
  if constexpr (detail::is_wide<T>)
    if (x.held().bound == 0) return static_cast<T>(detail::bits(detail::needed_value(x.held().number)));
  return static_cast<T>(symreal_value(x.number()));
}
namespace types {
template <class Character, class Traits, class T>
std::basic_ostream<Character, Traits> &operator<<(std::basic_ostream<Character, Traits> &out, SymbolicInt<T> x) {
  if constexpr (std::is_same_v<Character, char>)
    if (x.is_symbolic()) detail::made_stream(out, static_cast<long long>(symreal_value(x)), x.number());
  return out << symreal_value(x);
}
} // namespace types

} // namespace symreal

#define MATH_OPERATION(id, ...) using symreal::id;
#include <symreal/math_functions.def>
using symreal::fabs;
using symreal::nearbyint;
namespace std {
#include <symreal/math_functions.def>
using symreal::clamp;
using symreal::fabs;
using symreal::max;
using symreal::min;
using symreal::nearbyint;
} // namespace std
#undef MATH_OPERATION
