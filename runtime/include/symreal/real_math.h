// The functions of <cmath> on RealNumber: those of the operation table derive from it, the rest is written out.
#pragma once

#include <symreal/real_number.h>

#include <cstdlib>
#include <limits>

namespace symreal {

// A row that is spelled as a call becomes an overload; operators belong to RealNumber itself. They are functions of the
// library (trace/nodes/functions.cpp) rather than inline: each has one address, and their return address is the user's
// line.
#define SYMREAL_CALL_1(id) RealNumber id(RealNumber x) noexcept;
#define SYMREAL_CALL_2(id)                                                                                             \
  RealNumber id(RealNumber x, RealNumber y) noexcept;                                                                  \
  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>> RealNumber id(RealNumber x, T y) noexcept {    \
    return id(x, RealNumber(y));                                                                                       \
  }                                                                                                                    \
  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>> RealNumber id(T x, RealNumber y) noexcept {    \
    return id(RealNumber(x), y);                                                                                       \
  }
#define SYMREAL_CALL_3(id)                                                                                             \
  RealNumber id(RealNumber x, RealNumber y, RealNumber z) noexcept;                                                    \
  SYMREAL_MIXED_3(id, RealNumber, T, U)                                                                                \
  SYMREAL_MIXED_3(id, T, RealNumber, U)                                                                                \
  SYMREAL_MIXED_3(id, T, U, RealNumber)                                                                                \
  SYMREAL_MIXED_3(id, RealNumber, RealNumber, T)                                                                       \
  SYMREAL_MIXED_3(id, RealNumber, T, RealNumber)                                                                       \
  SYMREAL_MIXED_3(id, T, RealNumber, RealNumber)
// A better match than the library's overload for mixed types, which would call itself.
#define SYMREAL_MIXED_3(id, X, Y, Z)                                                                                   \
  template <class T, class U = int, class = std::enable_if_t<std::is_arithmetic_v<T> && std::is_arithmetic_v<U>>>      \
  RealNumber id(X x, Y y, Z z) noexcept {                                                                              \
    return id(RealNumber(x), RealNumber(y), RealNumber(z));                                                            \
  }
#define MATH_OPERATION(id, arity, evaluate) SYMREAL_CALL_##arity(id)
#include <symreal/math_functions.def>
#undef MATH_OPERATION
#undef SYMREAL_CALL_1
#undef SYMREAL_CALL_2
#undef SYMREAL_CALL_3
#undef SYMREAL_MIXED_3

inline RealNumber fabs(RealNumber x) noexcept { return abs(x); }
inline RealNumber nearbyint(RealNumber x) noexcept { return rint(x); }
// In steps where one power of two would overflow or vanish; what a step of 2^-1022 rounds, the rest takes to zero.
inline RealNumber ldexp(RealNumber x, int exponent) noexcept {
  constexpr int most = 1023, least = -1074, step = 1022, beyond = 4000;
  exponent = exponent < -beyond ? -beyond : beyond < exponent ? beyond : exponent;
  RealNumber product = x;
  for (; exponent > most; exponent -= most) product = product * RealNumber(std::ldexp(1.0, most));
  for (; exponent < least; exponent += step) product = product * RealNumber(std::ldexp(1.0, -step));
  product = product * RealNumber(std::ldexp(1.0, exponent));
  if (product.is_node()) detail::may_set_error(product);
  return product;
}
inline RealNumber scalbn(RealNumber x, int exponent) noexcept { return ldexp(x, exponent); }
inline RealNumber modf(RealNumber x, RealNumber *integer) noexcept { return x - (*integer = trunc(x)); }
inline void sincos(RealNumber x, RealNumber *sine, RealNumber *cosine) noexcept {
  *sine = sin(x);
  *cosine = cos(x);
}

// As libstdc++ computes it: scaled by the largest.
inline RealNumber hypot(RealNumber x, RealNumber y, RealNumber z) noexcept {
  if (!x.is_node() && !y.is_node() && !z.is_node()) return std::hypot(x.plain(), y.plain(), z.plain());
  x = abs(x), y = abs(y), z = abs(z);
  RealNumber const largest = select(x < y, select(y < z, z, y), select(x < z, z, x));
  RealNumber const a = x / largest, b = y / largest, c = z / largest;
  return select(largest != RealNumber(0.0), largest * sqrt(a * a + b * b + c * c), RealNumber(0.0));
}

// Rounding to an integer type is rounding and a conversion (symbolic_int.h).
SymbolicInt<long> lround(RealNumber x) noexcept;
SymbolicInt<long long> llround(RealNumber x) noexcept;
SymbolicInt<long> lrint(RealNumber x) noexcept;
SymbolicInt<long long> llrint(RealNumber x) noexcept;

// The exponent is that of the recorded value, under a guard that it stays the same.
inline int ilogb(RealNumber x) noexcept { return std::ilogb(x.is_node() ? detail::value_of_exponent(x) : x.plain()); }
inline RealNumber frexp(RealNumber x, int *exponent) noexcept {
  if (!x.is_node()) return std::frexp(x.plain(), exponent);
  std::frexp(detail::value_of_exponent(x), exponent);
  return x * RealNumber(std::ldexp(1.0, -*exponent));
}
// The quotient has its last three bits, as that of glibc.
inline RealNumber remquo(RealNumber x, RealNumber y, int *quotient) noexcept {
  if (!x.is_node() && !y.is_node()) return std::remquo(x.plain(), y.plain(), quotient);
  RealNumber const rest = remainder(x, y);
  auto const whole = static_cast<long long>(rint((x - rest) / y));
  *quotient = static_cast<int>(whole % 8);
  return rest;
}
template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
RealNumber remquo(RealNumber x, T y, int *quotient) noexcept {
  return remquo(x, RealNumber(y), quotient);
}
template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
RealNumber remquo(T x, RealNumber y, int *quotient) noexcept {
  return remquo(RealNumber(x), y, quotient);
}

// Conditions like any comparison. Under the premise of mode finite the first three are constants.
inline SymbolicBool isnan(RealNumber x) noexcept {
  return SymbolicBool::from_condition(x.is_node() ? detail::compare(Op::ne, x, x) : RealNumber(std::isnan(x.plain())));
}
inline SymbolicBool isfinite(RealNumber x) noexcept {
  return SymbolicBool::from_condition(x.is_node() ? detail::compare_finite(x) : RealNumber(std::isfinite(x.plain())));
}
inline SymbolicBool isinf(RealNumber x) noexcept {
  if (!x.is_node()) return SymbolicBool(std::isinf(x.plain()));
  return (!isfinite(x)) & (!isnan(x));
}
inline SymbolicBool signbit(RealNumber x) noexcept {
  if (!x.is_node()) return SymbolicBool(std::signbit(x.plain()));
  return copysign(RealNumber(1.0), x) < RealNumber(0.0);
}
inline SymbolicBool isnormal(RealNumber x) noexcept {
  if (!x.is_node()) return SymbolicBool(std::isnormal(x.plain()));
  RealNumber const magnitude = abs(x);
  return (magnitude >= RealNumber(std::numeric_limits<double>::min())) & isfinite(x);
}
// The class of a number that is in the same one; each condition decides.
inline int fpclassify(RealNumber x) noexcept {
  using limits = std::numeric_limits<double>;
  double const same = isnan(x)               ? limits::quiet_NaN()
                      : isinf(x)             ? limits::infinity()
                      : x == RealNumber(0.0) ? 0.0
                      : isnormal(x)          ? 1.0
                                             : limits::denorm_min();
  return std::fpclassify(same);
}
// The comparisons that raise no exception are those that do here.
inline SymbolicBool isgreater(RealNumber x, RealNumber y) noexcept { return x > y; }
inline SymbolicBool isgreaterequal(RealNumber x, RealNumber y) noexcept { return x >= y; }
inline SymbolicBool isless(RealNumber x, RealNumber y) noexcept { return x < y; }
inline SymbolicBool islessequal(RealNumber x, RealNumber y) noexcept { return x <= y; }
inline SymbolicBool islessgreater(RealNumber x, RealNumber y) noexcept { return (x < y) | (x > y); }
inline SymbolicBool isunordered(RealNumber x, RealNumber y) noexcept { return isnan(x) | isnan(y); }

} // namespace symreal

// C code calls them unqualified, C++ code as std::; both reach the overloads.
#define SYMREAL_USED_REAL(name) using symreal::name;
#define SYMREAL_USED_PLAIN(name)
#define MATH_OPERATION(id, ...) using symreal::id;
#define MATH_FUNCTION(name, types, numbers) SYMREAL_USED_##numbers(name)
#include <symreal/math_functions.def>
namespace std {
#include <symreal/math_functions.def>
} // namespace std
#undef MATH_OPERATION
#undef MATH_FUNCTION
#undef SYMREAL_USED_REAL
#undef SYMREAL_USED_PLAIN
