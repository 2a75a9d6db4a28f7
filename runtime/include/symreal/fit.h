// Implicit conversions of C and C++ that a class, or a compiler of C++, does not make by itself.
#pragma once

#include <symreal/type_traits.h>

#include <type_traits>
#include <utility>

namespace symreal {

// A value assigned to a target whose type the text leaves open: the same macro, or the same file included again, may
// assign to an integer once and to a real number another time. The context determines the conversion.
template <class From> class Fit {
public:
  [[gnu::always_inline]] explicit constexpr Fit(From value) noexcept : value_(value) {}
  // Converts as the language does: a symbolic number to an integer or a float by a decision; a pointer as in C.
  template <class To> [[gnu::always_inline]] constexpr operator To() const noexcept { return (To)value_; }

private:
  From value_;
};

template <class T> [[gnu::always_inline]] constexpr auto symreal_fit(T const &value) noexcept {
  using From = std::decay_t<T const &>;
  if constexpr (detail::is_class<From> && !std::is_same_v<From, RealNumber>)
    return value;
  else
    return Fit<From>(value);
}

// The argument of a call in a template, as a double converts to the parameter of the function that was chosen for it. A
// class would choose another function, or convert by another way.
template <class To, class From>
[[gnu::always_inline]] constexpr decltype(auto) symreal_argument_as(From &&value) noexcept {
  using Plain = std::remove_cvref_t<From>;
  if constexpr (std::is_same_v<Plain, RealNumber> || std::is_same_v<Plain, SymbolicBool>)
    return static_cast<To>(value);
  else
    return static_cast<From &&>(value);
}

namespace detail {

// A type with REAL in place of double.
template <class T> struct Recorded {
  using Type = T;
};
template <> struct Recorded<double> {
  using Type = RealNumber;
};
template <class T> struct Recorded<T const> {
  using Type = typename Recorded<T>::Type const;
};
template <class T> struct Recorded<T *> {
  using Type = typename Recorded<T>::Type *;
};
template <class T, __SIZE_TYPE__ n> struct Recorded<T[n]> {
  using Type = typename Recorded<T>::Type[n];
};
template <class T, __SIZE_TYPE__ n> struct Recorded<T const[n]> {
  using Type = typename Recorded<T>::Type const[n];
};
template <template <class...> class C, class... T> struct Recorded<C<T...>> {
  using Type = C<typename Recorded<T>::Type...>;
};
template <template <class, auto, auto...> class C, class T, auto first, auto... more>
struct Recorded<C<T, first, more...>> {
  using Type = C<typename Recorded<T>::Type, first, more...>;
};

// A constant object of doubles as one of REALs: a double is a REAL without a node. The assembly keeps the compiler
// from telling them apart by their types.
template <class To, class From> [[gnu::always_inline]] constexpr To *recorded_object(From *object) noexcept {
  static_assert(sizeof(To) == sizeof(From) && alignof(To) == alignof(From));
  void const *at = object;
  asm("" : "+r"(at) : : "memory");
  return static_cast<To *>(const_cast<void *>(at));
}

// A copy for which a compiler can account: elements of a class with operators of its own are copied one by one.
template <class To, class From> constexpr To recorded_copy(From const &from) noexcept {
  if constexpr (std::is_same_v<To, From> || std::is_arithmetic_v<From>)
    return To(from);
  else if constexpr (std::is_trivially_copyable_v<From>)
    return __builtin_bit_cast(To, from);
  else if constexpr (requires { from.first, from.second; })
    return To(recorded_copy<decltype(To::first)>(from.first), recorded_copy<decltype(To::second)>(from.second));
  else {
    To to{};
    for (decltype(from.size()) k = 0; k < from.size(); ++k)
      to[k] = recorded_copy<std::remove_reference_t<decltype(to[k])>>(from[k]);
    return to;
  }
}
template <class T> struct Holder {
  T symreal_object;
};
template <class From> constexpr auto recorded_constant(From const &from) noexcept {
  using To = typename Recorded<From>::Type;
  if constexpr (std::is_array_v<From>)
    return __builtin_bit_cast(Holder<To>, from);
  else
    return Holder<To>{recorded_copy<To>(from)};
}

// The result of a function as the constant object of doubles that it initialises.
template <class From> class PlainObject {
public:
  explicit constexpr PlainObject(From const &from) noexcept : from_(from) {}
  template <class To> constexpr operator To() const noexcept { return recorded_copy<To>(from_); }

private:
  From from_;
};

} // namespace detail

// One constant object of REALs for each of doubles.
template <auto const &object> inline constexpr auto symreal_constant = detail::recorded_constant(object);

// The same of a local object, which lives as long as the expression around it.
template <class From> constexpr auto symreal_local_constant(From const &from) noexcept {
  return detail::recorded_constant(from);
}

template <class From> constexpr detail::PlainObject<From> symreal_plain_object(From const &from) noexcept {
  return detail::PlainObject<From>(from);
}

// Argument from which a template of the program deduces a type: a double becomes a REAL, a constant object of doubles
// one of REALs, other types pass unchanged.
template <class From> [[gnu::always_inline]] constexpr decltype(auto) symreal_deduced(From &&value) noexcept {
  using Plain = std::remove_cvref_t<From>;
  using Object = std::remove_reference_t<From>;
  if constexpr (std::is_same_v<Plain, double>)
    return RealNumber(value);
  else if constexpr (std::is_same_v<typename detail::Recorded<Plain>::Type, Plain>)
    return static_cast<From &&>(value);
  else if constexpr (std::is_pointer_v<Plain>)
    return detail::recorded_object<std::remove_pointer_t<typename detail::Recorded<Plain>::Type>>(value);
  else if constexpr (std::is_lvalue_reference_v<From> && std::is_const_v<std::remove_all_extents_t<Object>>)
    return static_cast<typename detail::Recorded<Plain>::Type const &>(
        *detail::recorded_object<typename detail::Recorded<Plain>::Type const>(__builtin_addressof(value)));
  else
    return static_cast<From &&>(value);
}

// An enumerator in a template, which is converted to a number, as the integer that it is promoted to. Other types pass
// unchanged.
template <class From> constexpr auto symreal_integer(From &&value) noexcept {
  using Plain = std::remove_cvref_t<From>;
  if constexpr (std::is_enum_v<Plain> && std::is_convertible_v<Plain, int>)
    return +value;
  else
    return Plain(static_cast<From &&>(value));
}

// Increment and decrement of C's truth values: ++ yields true, -- inverts.
class CountedTruth {
public:
  explicit constexpr CountedTruth(bool &value) noexcept : value_(value) {}
  constexpr bool operator++() const noexcept { return value_ = true; }
  constexpr bool operator--() const noexcept { return value_ = !value_; }
  constexpr bool operator++(int) const noexcept { return std::exchange(value_, true); }
  constexpr bool operator--(int) const noexcept { return std::exchange(value_, !value_); }

private:
  bool &value_;
};

// The left operand of a compound assignment: in C an enumerator is an integer.
template <class E> constexpr decltype(auto) symreal_enumeration(E &x) noexcept {
  if constexpr (std::is_same_v<E, bool>)
    return CountedTruth(x);
  else if constexpr (std::is_enum_v<E>) {
    using Integer [[gnu::may_alias]] = std::underlying_type_t<E>;
    return (reinterpret_cast<Integer &>(x));
  } else
    return (x);
}

} // namespace symreal

// C's increment and decrement of enumerations. C++ has no built-in ones, so these conflict with nothing.
#define SYMREAL_ENUMERATION                                                                                            \
  template <class E, std::enable_if_t<std::is_enum_v<E> && std::is_convertible_v<E, int>, int> = 0>
SYMREAL_ENUMERATION constexpr E &operator++(E &x) noexcept { return x = static_cast<E>(x + 1); }
SYMREAL_ENUMERATION constexpr E &operator--(E &x) noexcept { return x = static_cast<E>(x - 1); }
SYMREAL_ENUMERATION constexpr E operator++(E &x, int) noexcept {
  E const old = x;
  ++x;
  return old;
}
SYMREAL_ENUMERATION constexpr E operator--(E &x, int) noexcept {
  E const old = x;
  --x;
  return old;
}
#undef SYMREAL_ENUMERATION
