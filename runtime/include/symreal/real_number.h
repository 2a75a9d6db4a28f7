// RealNumber: the type that replaces double while a program records itself.
//
// It is 8 bytes, trivially copyable, and its only member is a double. An ordinary double *is* a constant; a node of the
// recorded graph rides in the payload of a signalling NaN with the sign bit set:
//
//   63            52 51 50 49             32 31              0
//   1 111 1111 1111  0  1  check (18 bit)    node id (32 bit)
//
// So all-zero bytes are 0.0, memcpy, unions, calloc and arrays keep working, and sizeof is unchanged. Arithmetic that
// is not instrumented makes the NaN quiet (bit 51) and keeps the rest: a leak that names its node. An uninstrumented
// fabs or negation clears the sign bit. Both are caught when the value is next read. The check bits depend on all bits
// of the id and on the recording that the node belongs to, so that neither a node of another recording or thread nor a
// number of which the program has overwritten some bytes is taken for a node (trace/nodes/payload.h). They are never 0:
// so the negative of numeric_limits<double>::signaling_NaN(), which has the shape of a node, is a constant.
#pragma once

#include <symreal/op.h>

#ifdef SYMREAL_SOURCE_OF_C // the special functions are names of C++; gcc would compile them with each source
#include <cstddef>
#undef _GLIBCXX_USE_STD_SPEC_FUNCS
#endif
#include <cmath>
#include <compare>
#include <cstdint>
#include <type_traits>

// The types have a namespace of their own, with their operators and nothing else: for a double the language looks into
// no namespace, so a program's own max(x, y) or value(x) must not meet the functions of ours.
namespace symreal {
namespace types {
class RealNumber;
class SymbolicBool;
template <class T> class SymbolicInt;
} // namespace types
using types::RealNumber;
using types::SymbolicBool;
using types::SymbolicInt;
} // namespace symreal

// Code that asks for a floating-point number means RealNumber, too, and would take its other way otherwise. The
// standard reserves these specialisations; the libraries at hand honour them, in std::is_arithmetic and the concepts as
// well.
template <> struct std::is_floating_point<symreal::RealNumber> : std::true_type {};
template <> struct std::is_floating_point<symreal::RealNumber const> : std::true_type {};
template <> struct std::is_floating_point<symreal::RealNumber volatile> : std::true_type {};
template <> struct std::is_floating_point<symreal::RealNumber const volatile> : std::true_type {};

namespace symreal {

namespace detail {

// True if the compiler sees a class; std::is_class treats RealNumber as double.
template <class T> inline constexpr bool is_class = __is_class(T);

// Bits 63..50 of every node. As a constant, it leaves no trace of the path in the registers of the test.
inline constexpr std::uint64_t node_shape = 0x3FFDu;
inline constexpr unsigned node_shape_at = 50;
constexpr std::uint64_t bits(double value) noexcept { return __builtin_bit_cast(std::uint64_t, value); }

// Number of operations executed, by kind and thread, with or without node operands.
extern __thread std::uint64_t executed[static_cast<unsigned>(Op::count)];

// Slow paths, in the library. `record` makes or finds the node of an operation.
[[gnu::noinline]] RealNumber record(Op op, RealNumber x, RealNumber y, RealNumber z) noexcept;
// An operation on any operands, out of line: for sources in which an inline test for nodes at each operation would
// overload the compiler (SYMREAL_CALLED_OPERATORS).
[[gnu::noinline]] RealNumber operate(Op op, RealNumber x, RealNumber y) noexcept;
[[gnu::noinline]] double carried_value(RealNumber x) noexcept;
// As carried_value, for a use that needs the value: an input without one is an error.
[[gnu::noinline]] double needed_value(RealNumber x) noexcept;
// As above, for conversion to text (text.h).
[[gnu::noinline]] double shown_value(RealNumber x) noexcept;
// The node of a comparison; a truth value if the premise of the floating-point mode settles it (x != x).
[[gnu::noinline]] RealNumber compare(Op op, RealNumber x, RealNumber y) noexcept;
// The condition that x is finite; settled like a comparison.
[[gnu::noinline]] RealNumber compare_finite(RealNumber x) noexcept;
// A decision on a condition, a conversion: the program goes on with the carried value. By policy the decision becomes
// a guard of the kernel, or its place is reported.
// It takes the bits of the number, and lets the runtime see the whole state of its caller (trace/decisions/stand.cpp).
bool decide_on(std::uint64_t condition) noexcept;
[[gnu::always_inline]] inline bool decide(RealNumber condition) noexcept;
// The recorded value, under a guard that its exponent stays the same.
[[gnu::noinline]] double value_of_exponent(RealNumber x) noexcept;
[[gnu::noinline]] double convert_to_integer(RealNumber x) noexcept;
[[gnu::noinline]] double convert(RealNumber x) noexcept;
// Notes that x is computed by a function that may set errno.
[[gnu::noinline]] void may_set_error(RealNumber x) noexcept;
// True if both arms of a decision are recorded where possible, and truth values become numbers without a decision.
bool selects() noexcept;

template <class> inline constexpr bool is_symbolic_int = false;
template <class T> inline constexpr bool is_symbolic_int<SymbolicInt<T>> = true;

} // namespace detail

namespace types {

// packed: compilers ignore `packed` on a structure with a member whose class is not packed itself. The alignment stays
// that of a double.
class [[gnu::packed, gnu::aligned(alignof(double))]] RealNumber {
public:
  double value_; // public, so that a template may have a constant of a class of numbers as an argument

private:
  template <class T> using IfReal = std::enable_if_t<std::is_same_v<T, RealNumber>, int>;
  template <class T> using IfOther =
      std::enable_if_t<std::is_arithmetic_v<T> && !std::is_same_v<std::remove_cv_t<T>, RealNumber>, int>;

public:
  RealNumber() = default;
  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>> constexpr RealNumber(T value) noexcept
      : value_(static_cast<double>(value)) {}

  template <class T, std::enable_if_t<std::is_enum_v<T>, int> = 0> explicit constexpr RealNumber(T value) noexcept
      : value_(static_cast<double>(value)) {}
  // Copies from and to volatile numbers, recorded like any other. As templates they do not count as copy operations, so
  // the class stays trivially copyable.
  template <class T, IfReal<T> = 0> constexpr RealNumber(T const volatile &other) noexcept : value_(other.value_) {}
  template <class T, IfReal<T> = 0> constexpr RealNumber(T const volatile &&other) noexcept : value_(other.value_) {}
  template <class T, IfReal<T> = 0> void operator=(T const volatile &other) volatile noexcept { value_ = other.value_; }
  template <class T, IfReal<T> = 0> void operator=(T const volatile &&other) volatile noexcept {
    value_ = other.value_;
  }
  template <class T, IfOther<T> = 0> void operator=(T const &other) volatile noexcept {
    value_ = static_cast<double>(other);
  }
  template <class T, IfReal<T> = 0> constexpr RealNumber &operator=(T const volatile &other) noexcept {
    value_ = other.value_;
    return *this;
  }
  template <class T, IfReal<T> = 0> constexpr RealNumber &operator=(T const volatile &&other) noexcept {
    value_ = other.value_;
    return *this;
  }
  template <class T, IfOther<T> = 0> constexpr RealNumber &operator=(T const &other) noexcept {
    return *this = RealNumber(other);
  }

  // 1 if the condition holds, else 0: symbolic under policy `select`, else by a decision.
  inline RealNumber(SymbolicBool condition) noexcept;

  static constexpr RealNumber from_bits(std::uint64_t bits) noexcept {
    RealNumber number(0.0);
    number.value_ = __builtin_bit_cast(double, bits);
    return number;
  }
  constexpr std::uint64_t to_bits() const noexcept { return detail::bits(value_); }
  constexpr bool is_node() const noexcept { return to_bits() >> detail::node_shape_at == detail::node_shape; }
  // The number itself. Requires !is_node().
  constexpr double plain() const noexcept { return value_; }

  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T> && !std::is_same_v<T, bool>>>
  [[gnu::always_inline]] explicit constexpr operator T() const noexcept {
    if (!is_node()) return static_cast<T>(value_);
    return static_cast<T>(std::is_integral_v<T> ? detail::convert_to_integer(*this) : detail::convert(*this));
  }
  template <class T, std::enable_if_t<std::is_enum_v<T>, int> = 0>
  [[gnu::always_inline]] explicit constexpr operator T() const noexcept {
    return static_cast<T>(static_cast<std::underlying_type_t<T>>(*this));
  }
  [[gnu::always_inline]] explicit constexpr operator bool() const noexcept {
    return is_node() ? detail::decide(detail::compare(Op::ne, *this, RealNumber(0.0))) : value_ != 0;
  }

  // Always inline, here and below: the return address that `record` sees is then the user's line.
  [[gnu::always_inline]] constexpr RealNumber &operator+=(RealNumber other) noexcept { return *this = *this + other; }
  [[gnu::always_inline]] constexpr RealNumber &operator-=(RealNumber other) noexcept { return *this = *this - other; }
  [[gnu::always_inline]] constexpr RealNumber &operator*=(RealNumber other) noexcept { return *this = *this * other; }
  [[gnu::always_inline]] constexpr RealNumber &operator/=(RealNumber other) noexcept { return *this = *this / other; }
  [[gnu::always_inline]] constexpr RealNumber &operator++() noexcept { return *this = *this + RealNumber(1.0); }
  [[gnu::always_inline]] constexpr RealNumber &operator--() noexcept { return *this = *this - RealNumber(1.0); }
  [[gnu::always_inline]] constexpr RealNumber operator++(int) noexcept {
    RealNumber old = *this;
    ++*this;
    return old;
  }
  [[gnu::always_inline]] constexpr RealNumber operator--(int) noexcept {
    RealNumber old = *this;
    --*this;
    return old;
  }

  friend constexpr RealNumber operator+(RealNumber x) noexcept { return x; }
  [[gnu::always_inline]] friend constexpr RealNumber operator-(RealNumber x) noexcept {
    if (!__builtin_is_constant_evaluated()) {
      ++detail::executed[static_cast<unsigned>(Op::neg)];
      if (x.is_node()) return detail::record(Op::neg, x, 0.0, 0.0);
    }
    return -x.value_;
  }
#ifdef SYMREAL_CALLED_OPERATORS
#define SYMREAL_ARITHMETIC(op, id)                                                                                     \
  [[gnu::always_inline]] friend constexpr RealNumber operator op(RealNumber x, RealNumber y) noexcept {                \
    if (!__builtin_is_constant_evaluated()) return detail::operate(Op::id, x, y);                                      \
    return x.value_ op y.value_;                                                                                       \
  }
#else
#define SYMREAL_ARITHMETIC(op, id)                                                                                     \
  [[gnu::always_inline]] friend constexpr RealNumber operator op(RealNumber x, RealNumber y) noexcept {                \
    if (!__builtin_is_constant_evaluated()) {                                                                          \
      ++detail::executed[static_cast<unsigned>(Op::id)];                                                               \
      if (x.is_node() || y.is_node()) return detail::record(Op::id, x, y, 0.0);                                        \
    }                                                                                                                  \
    return x.value_ op y.value_;                                                                                       \
  }
#endif
  SYMREAL_ARITHMETIC(+, add)
  SYMREAL_ARITHMETIC(-, sub)
  SYMREAL_ARITHMETIC(*, mul)
  SYMREAL_ARITHMETIC(/, div)
#undef SYMREAL_ARITHMETIC
};

static_assert(sizeof(RealNumber) == 8 && alignof(RealNumber) == alignof(double));
static_assert(std::is_trivially_copyable_v<RealNumber> && std::is_trivially_default_constructible_v<RealNumber>);

// Result of a comparison: a truth value that keeps its symbolic condition. Converting it to bool is a decision.
class SymbolicBool {
public:
  // Explicit: otherwise `c ? x < y : flag` might become either type.
  explicit constexpr SymbolicBool(bool value) noexcept : condition_(value) {}
  // Not defaulted: compilers refuse to pass a class with a user-provided copy constructor through `...`, whose callee
  // would misread the bytes.
  constexpr SymbolicBool(SymbolicBool const &other) noexcept : condition_(other.condition_) {}
  constexpr SymbolicBool &operator=(SymbolicBool const &) = default;
  constexpr SymbolicBool &operator=(bool value) noexcept { return *this = SymbolicBool(value); }
  // From a comparison's node, or from 0 or 1.
  static constexpr SymbolicBool from_condition(RealNumber condition) noexcept {
    SymbolicBool result(false);
    result.condition_ = condition;
    return result;
  }

  [[gnu::always_inline]] constexpr operator bool() const noexcept {
    return condition_.is_node() ? detail::decide(condition_) : holds();
  }
  // Requires !is_symbolic(). Compares bits: a compiler may hoist a comparison of numbers above the test for a node, and
  // comparing a node is an invalid operation.
  constexpr bool holds() const noexcept { return condition_.to_bits() != 0; }
  constexpr bool is_symbolic() const noexcept { return condition_.is_node(); }
  // The truth value as a number: a node if symbolic, else 0 or 1.
  constexpr RealNumber condition() const noexcept { return condition_; }

private:
  RealNumber condition_;
};

} // namespace types

// Clears dead callee-saved registers, so that they are the same on every path to a decision. (Clang may address its
// stack by rbx.)
inline bool detail::decide(RealNumber condition) noexcept {
#if defined(__x86_64__) && defined(__clang__)
  asm volatile("xorl %%r12d, %%r12d\n\txorl %%r13d, %%r13d\n\txorl %%r14d, %%r14d\n\txorl %%r15d, %%r15d" ::
                   : "r12", "r13", "r14", "r15", "cc");
#elif defined(__x86_64__)
  asm volatile("xorl %%ebx, %%ebx\n\txorl %%r12d, %%r12d\n\txorl %%r13d, %%r13d\n\txorl %%r14d, %%r14d\n\t"
               "xorl %%r15d, %%r15d" ::
                   : "rbx", "r12", "r13", "r14", "r15", "cc");
#endif
  return decide_on(condition.to_bits());
}

namespace types {

#define SYMREAL_COMPARISON(op, id)                                                                                     \
  [[gnu::always_inline]] inline constexpr SymbolicBool operator op(RealNumber x, RealNumber y) noexcept {              \
    if (__builtin_is_constant_evaluated() || (!x.is_node() && !y.is_node()))                                           \
      return SymbolicBool(x.plain() op y.plain());                                                                     \
    return SymbolicBool::from_condition(detail::compare(Op::id, x, y));                                                \
  }
SYMREAL_COMPARISON(<, lt)
SYMREAL_COMPARISON(<=, le)
SYMREAL_COMPARISON(>, gt)
SYMREAL_COMPARISON(>=, ge)
SYMREAL_COMPARISON(==, eq)
SYMREAL_COMPARISON(!=, ne)
#undef SYMREAL_COMPARISON
// Compares plain values; each comparison is a decision.
[[gnu::always_inline]] inline constexpr std::partial_ordering operator<=>(RealNumber x, RealNumber y) noexcept {
  if (x < y) return std::partial_ordering::less;
  if (x > y) return std::partial_ordering::greater;
  return x == y ? std::partial_ordering::equivalent : std::partial_ordering::unordered;
}

// Conditions combined without deciding: both sides are evaluated. (&& and || decide each side, as the language has it.)
[[gnu::always_inline]] inline SymbolicBool operator&(SymbolicBool x, SymbolicBool y) noexcept {
  if (!x.is_symbolic()) return x.holds() ? y : x;
  if (!y.is_symbolic()) return y.holds() ? x : y;
  return SymbolicBool::from_condition(detail::record(Op::logical_and, x.condition(), y.condition(), 0.0));
}
[[gnu::always_inline]] inline SymbolicBool operator|(SymbolicBool x, SymbolicBool y) noexcept {
  if (!x.is_symbolic()) return x.holds() ? x : y;
  if (!y.is_symbolic()) return y.holds() ? y : x;
  return SymbolicBool::from_condition(detail::record(Op::logical_or, x.condition(), y.condition(), 0.0));
}
[[gnu::always_inline]] inline SymbolicBool operator!(SymbolicBool x) noexcept {
  if (!x.is_symbolic()) return SymbolicBool(!x.holds());
  return SymbolicBool::from_condition(detail::record(Op::logical_not, x.condition(), 0.0, 0.0));
}

template <class T, bool = __is_class(T)> inline constexpr bool is_plain_number = false;
template <class T> inline constexpr bool is_plain_number<T, false> = std::is_arithmetic_v<T>;

// Overloads for a plain number, without a conversion: with one, a class that has the operator and a constructor
// from a number would be as good a match, as vector(int) in 5 * epsilon.
#define SYMREAL_BESIDE_PLAIN(op)                                                                                       \
  template <class T, std::enable_if_t<is_plain_number<T>, int> = 0>                                                    \
  [[gnu::always_inline]] constexpr RealNumber operator op(T x, RealNumber y) noexcept {                                \
    return RealNumber(x) op y;                                                                                         \
  }                                                                                                                    \
  template <class T, std::enable_if_t<is_plain_number<T>, int> = 0>                                                    \
  [[gnu::always_inline]] constexpr RealNumber operator op(RealNumber x, T y) noexcept {                                \
    return x op RealNumber(y);                                                                                         \
  }
SYMREAL_BESIDE_PLAIN(+)
SYMREAL_BESIDE_PLAIN(-)
SYMREAL_BESIDE_PLAIN(*)
SYMREAL_BESIDE_PLAIN(/)
#undef SYMREAL_BESIDE_PLAIN

// i += x for an arithmetic i, as in the original: with a conversion back.
#define SYMREAL_COMPOUND(op)                                                                                           \
  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>                                                \
  constexpr T &operator op##=(T & x, RealNumber y) noexcept {                                                          \
    x = static_cast<std::remove_cv_t<T>>(RealNumber(x) op y);                                                          \
    return x;                                                                                                          \
  }
SYMREAL_COMPOUND(+)
SYMREAL_COMPOUND(-)
SYMREAL_COMPOUND(*)
SYMREAL_COMPOUND(/)
#undef SYMREAL_COMPOUND

} // namespace types

// The carried value: the number that the program would have here. For printing; no dependency is recorded.
constexpr double symreal_value(RealNumber x) noexcept { return x.is_node() ? detail::shown_value(x) : x.plain(); }
template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>> constexpr T symreal_value(T x) noexcept {
  return x;
}
inline bool symreal_value(SymbolicBool x) noexcept { return symreal_value(x.condition()) != 0; }
// Values of other types, which a template may print, pass unchanged.
template <class T, class = std::enable_if_t<!std::is_arithmetic_v<std::decay_t<T>>>>
constexpr T &&symreal_value(T &&x) noexcept {
  return static_cast<T &&>(x);
}

// y if the condition holds, else z; both are computed.
[[gnu::always_inline]] inline RealNumber select(SymbolicBool condition, RealNumber y, RealNumber z) noexcept {
  if (condition.is_symbolic()) return detail::record(Op::select, condition.condition(), y, z);
  return condition.holds() ? y : z;
}

[[gnu::always_inline]] inline types::RealNumber::RealNumber(SymbolicBool condition) noexcept : value_(0) {
  if (!condition.is_symbolic() || !detail::selects())
    value_ = static_cast<bool>(condition) ? 1 : 0;
  else
    *this = select(condition, 1.0, 0.0);
}

} // namespace symreal
