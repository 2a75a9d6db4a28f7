// Formulas of the standard library that decide on their arguments, as selects; and the types that it computes in.
#pragma once

#include <symreal/real_math.h>

#include <cmath>
#include <type_traits>

#ifdef __GLIBCXX__
// Promotion of mixed arguments: RealNumber acts like double. Without it the overload for RealNumber and another number
// would be discarded, and the one for int chosen.
template <> struct __gnu_cxx::__promote<symreal::RealNumber> {
  using __type = symreal::RealNumber;
};
#endif

namespace symreal {

namespace detail {
double midpoint(double a, double b) noexcept;
} // namespace detail

inline RealNumber midpoint(RealNumber a, RealNumber b) noexcept {
  if (!a.is_node() && !b.is_node()) return detail::midpoint(a.plain(), b.plain());
  RealNumber const small = std::numeric_limits<double>::min() * 2, large = std::numeric_limits<double>::max() / 2;
  RealNumber const half_a = a / 2.0, half_b = b / 2.0;
  return select((abs(a) <= large) & (abs(b) <= large), (a + b) / 2.0,
                select(abs(a) < small, a + half_b, select(abs(b) < small, half_a + b, half_a + half_b)));
}

inline RealNumber lerp(RealNumber a, RealNumber b, RealNumber t) noexcept {
  if (!a.is_node() && !b.is_node() && !t.is_node()) return std::lerp(a.plain(), b.plain(), t.plain());
  RealNumber const zero = 0.0, one = 1.0, x = a + t * (b - a);
  SymbolicBool const has_passed_1 = t > one, rises = b > a;
  SymbolicBool const in_order = (has_passed_1 & rises) | !(has_passed_1 | rises);
  return select(((a <= zero) & (b >= zero)) | ((a >= zero) & (b <= zero)), t * b + (one - t) * a,
                select(t == one, b, select(in_order, select(b < x, x, b), select(b > x, x, b))));
}

} // namespace symreal

namespace std {
using symreal::midpoint; // better than the template for arithmetic types
#ifdef __GLIBCXX__
// The functions to which the overloads for mixed types forward.
template <> inline symreal::RealNumber __hypot3(symreal::RealNumber x, symreal::RealNumber y, symreal::RealNumber z) {
  return symreal::hypot(x, y, z);
}
template <>
constexpr symreal::RealNumber __lerp(symreal::RealNumber a, symreal::RealNumber b, symreal::RealNumber t) noexcept {
  if (!__builtin_is_constant_evaluated()) return symreal::lerp(a, b, t);
  return std::lerp(a.plain(), b.plain(), t.plain());
}
#endif
} // namespace std
