// Integers of 64 bits that were computed from real numbers. A double holds them up to 53 bits only, so such an integer
// is recorded as a real number where its magnitude is known to be small, or where it was one (the conversion of a
// number, however large, is exact), and as its 64 bits, by operations of their own, everywhere else.
#pragma once

#include <symreal/extremes.h>

#include <cstdint>
#include <limits>

namespace symreal::detail {

inline constexpr double largest_exact = 0x1p53; // up to this magnitude every integer is a double

struct Integer64 {
  RealNumber number;   // a node: the integer as a real number, or, where `bound` is 0, its bits
  std::uint64_t plain; // the value, unless `number` is a node
  double bound;        // largest magnitude of a real number; 0 if `number` holds bits

  bool is_node() const noexcept { return number.is_node(); }
};

constexpr Integer64 integer64(std::uint64_t plain) noexcept { return {RealNumber(0.0), plain, 0}; }
inline Integer64 integer64_of_bits(RealNumber node) noexcept { return {node, 0, 0}; }
// The integer of an integral real number, whose magnitude is at most 2^53 if it is plain.
inline Integer64 integer64_of_number(RealNumber number, double bound) noexcept {
  if (!number.is_node()) return integer64(static_cast<std::uint64_t>(static_cast<std::int64_t>(number.plain())));
  return {number, 0, bound < 1 ? 1 : bound};
}

[[gnu::always_inline]] inline RealNumber bits_of(Integer64 x) noexcept {
  if (!x.is_node())
    return record(Op::wide, static_cast<double>(x.plain >> 32), static_cast<double>(x.plain & 0xFFFFFFFFu), 0.0);
  return x.bound == 0 ? x.number : record(Op::wide_int, x.number, 0.0, 0.0);
}

template <class T> double plain_value(Integer64 x) noexcept { return static_cast<double>(static_cast<T>(x.plain)); }

// The integer, of type T, as a real number, rounded if large.
template <class T> [[gnu::always_inline]] inline RealNumber real_of(Integer64 x) noexcept {
  if (!x.is_node()) return plain_value<T>(x);
  if (x.bound != 0) return x.number;
  return record(std::is_signed_v<T> ? Op::wide_value : Op::wide_uvalue, x.number, 0.0, 0.0);
}

// Largest magnitude of an integer whose real number is exact; infinity for any other.
template <class T> double bound_of(Integer64 x) noexcept {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (x.is_node()) return x.bound == 0 ? unknown : x.bound;
  double const magnitude = std::fabs(plain_value<T>(x));
  return magnitude <= largest_exact ? magnitude : unknown;
}
template <class T> bool is_small(Integer64 x) noexcept { return bound_of<T>(x) <= largest_exact; }
template <class T> bool is_small_constant(Integer64 x) noexcept {
  return !x.is_node() && std::fabs(plain_value<T>(x)) < largest_exact;
}

[[gnu::always_inline]] inline Integer64 wide(Op op, Integer64 x, Integer64 y) noexcept {
  return integer64_of_bits(record(op, bits_of(x), bits_of(y), 0.0));
}

// Arithmetic in the type C, of operands that are not both plain. A product of 0 and a negative number is -0 as a real
// number, and 0 as an integer; so are a quotient and a remainder of one.
template <class C> [[gnu::always_inline]] inline Integer64 sum(Integer64 x, Integer64 y) noexcept {
  double const bound = bound_of<C>(x) + bound_of<C>(y);
  if (bound <= largest_exact) return integer64_of_number(real_of<C>(x) + real_of<C>(y), bound);
  return wide(Op::wide_add, x, y);
}
// A node is not negated as 0 - x: gcc folds it to -x if x is converted from an integer, so that 0 would become -0.
[[gnu::always_inline]] inline RealNumber negative(RealNumber x) noexcept {
  return x.is_node() ? record(Op::int_neg, x, 0.0, 0.0) : RealNumber(0.0) - x;
}
inline bool is_zero(RealNumber x) noexcept { return !x.is_node() && x.plain() == 0; }
template <class C> [[gnu::always_inline]] inline Integer64 difference(Integer64 x, Integer64 y) noexcept {
  double const bound = bound_of<C>(x) + bound_of<C>(y);
  if (std::is_signed_v<C> && bound <= largest_exact && is_zero(real_of<C>(x)))
    return integer64_of_number(negative(real_of<C>(y)), bound);
  if (std::is_signed_v<C> && bound <= largest_exact) return integer64_of_number(real_of<C>(x) - real_of<C>(y), bound);
  return wide(Op::wide_sub, x, y);
}
template <class C> [[gnu::always_inline]] inline Integer64 product(Integer64 x, Integer64 y) noexcept {
  double const bound = bound_of<C>(x) * bound_of<C>(y);
  if (bound <= largest_exact) // false for 0 * infinity
    return integer64_of_number(real_of<C>(x) * real_of<C>(y) + RealNumber(0.0), bound);
  return wide(Op::wide_mul, x, y);
}
// The quotient of two integers of up to 53 bits, rounded, is never on the other side of an integer. It is an operation
// of its own, since a quotient of numbers may become a product with an inverse in mode fast.
[[gnu::always_inline]] inline RealNumber divided(RealNumber x, RealNumber y) noexcept {
  if (x.is_node() || y.is_node()) return record(Op::int_div, x, y, 0.0);
  return std::trunc(x.plain() / y.plain()) + 0.0;
}
template <class C> [[gnu::always_inline]] inline Integer64 quotient(Integer64 x, Integer64 y) noexcept {
  if (is_small<C>(x) && is_small_constant<C>(y) && y.plain != 0)
    return integer64_of_number(divided(real_of<C>(x), real_of<C>(y)), bound_of<C>(x));
  return wide(std::is_signed_v<C> ? Op::wide_div : Op::wide_udiv, x, y);
}
template <class C> [[gnu::always_inline]] inline Integer64 remainder_of(Integer64 x, Integer64 y) noexcept {
  if (std::isfinite(bound_of<C>(x)) && is_small_constant<C>(y) && y.plain != 0)
    return integer64_of_number(fmod(real_of<C>(x), real_of<C>(y)) + RealNumber(0.0), bound_of<C>(y));
  return wide(std::is_signed_v<C> ? Op::wide_rem : Op::wide_urem, x, y);
}

// Rounding to nearest does not carry an integer past a constant of less than 53 bits, so real numbers compare alike.
template <class C> bool compares_as_real(Integer64 x, Integer64 y) noexcept {
  return (std::isfinite(bound_of<C>(x)) && std::isfinite(bound_of<C>(y))) || is_small_constant<C>(x) ||
         is_small_constant<C>(y);
}
template <class C> [[gnu::always_inline]] inline SymbolicBool wide_less(Integer64 x, Integer64 y) noexcept {
  Op const op = std::is_signed_v<C> ? Op::wide_less : Op::wide_uless;
  return SymbolicBool::from_condition(record(op, bits_of(x), bits_of(y), 0.0));
}
[[gnu::always_inline]] inline SymbolicBool wide_equal(Integer64 x, Integer64 y) noexcept {
  return SymbolicBool::from_condition(record(Op::wide_equal, bits_of(x), bits_of(y), 0.0));
}
#define SYMREAL_COMPARE(name, op, otherwise)                                                                           \
  template <class C> [[gnu::always_inline]] inline SymbolicBool name(Integer64 x, Integer64 y) noexcept {              \
    if (compares_as_real<C>(x, y)) return real_of<C>(x) op real_of<C>(y);                                              \
    return otherwise;                                                                                                  \
  }
SYMREAL_COMPARE(less, <, wide_less<C>(x, y))
SYMREAL_COMPARE(less_or_equal, <=, !wide_less<C>(y, x))
SYMREAL_COMPARE(greater, >, wide_less<C>(y, x))
SYMREAL_COMPARE(greater_or_equal, >=, !wide_less<C>(x, y))
SYMREAL_COMPARE(equal, ==, wide_equal(x, y))
SYMREAL_COMPARE(not_equal, !=, !wide_equal(x, y))
#undef SYMREAL_COMPARE

// y where the condition holds, else z, of type C.
template <class C>
[[gnu::always_inline]] inline Integer64 select64(SymbolicBool condition, Integer64 y, Integer64 z) noexcept {
  if (!condition.is_symbolic()) return condition.holds() ? y : z;
  double const bound = bound_of<C>(y) < bound_of<C>(z) ? bound_of<C>(z) : bound_of<C>(y);
  if (std::isfinite(bound)) return integer64_of_number(select(condition, real_of<C>(y), real_of<C>(z)), bound);
  return integer64_of_bits(record(Op::wide_select, condition.condition(), bits_of(y), bits_of(z)));
}
// As above, for a result that is known to lie within 53 bits.
template <class C> [[gnu::always_inline]] inline Integer64 select_bounded(SymbolicBool condition, Integer64 y,
                                                                          Integer64 z, double bound) noexcept {
  return integer64_of_number(select(condition, real_of<C>(y), real_of<C>(z)), bound);
}

} // namespace symreal::detail
