// C's semantics for expressions to which C++ gives another type. Each function passes other operands unchanged: the
// text may be a macro's, compiled with several types.
#pragma once

#include <symreal/compound_literals.h>
#include <symreal/truth.h>
#include <symreal/variable_arrays.h>

#include <type_traits>

namespace symreal {
namespace detail {

// A truth value, a character, a short integer.
template <class T> inline constexpr bool is_narrow =
    std::is_integral_v<T> && !is_class<T> && (sizeof(T) < sizeof(int) || std::is_same_v<T, wchar_t>);

// Type of an operand as an rvalue: an array decays to a pointer.
template <class T> using Value = std::remove_cv_t<std::decay_t<T const &>>;

} // namespace detail

// A function of C takes a double; in C++ there may be others for float, long double and integers.
template <class T> [[gnu::always_inline]] constexpr auto symreal_promoted(T const &value) noexcept {
  if constexpr (!detail::is_class<T> &&
                (std::is_arithmetic_v<T> || std::is_enum_v<T>)) // traits hold for RealNumber too
    return static_cast<double>(value);
  else
    return value;
}

// A narrow integer or an enumerator, of type C there; an array that is a pointer there; a comparison of
// REALs or a symbolic integer, by a decision unless C is symbolic too or only its size is asked for.
template <class C, class T> [[gnu::always_inline]] constexpr auto symreal_of_c(T const &value) noexcept {
  using From = std::remove_cv_t<T>;
  if constexpr (detail::is_narrow<From> || std::is_enum_v<From> || std::is_same_v<From, SymbolicBool> ||
                detail::is_symbolic_int<From>)
    return static_cast<C>(value);
  else
    return static_cast<detail::Value<T>>(value);
}

// The value of an enumeration takes part in arithmetic as the integer that its objects are in C.
template <class T> [[gnu::always_inline]] constexpr decltype(auto) symreal_counted(T const &value) noexcept {
  if constexpr (std::is_enum_v<T>)
    return +static_cast<std::underlying_type_t<std::remove_cv_t<T>>>(value);
  else if constexpr (detail::is_class<T>)
    return (value);
  else
    return static_cast<detail::Value<T>>(value);
}

// gcc computes with a bit-field that is wider than int in as many bits as it has, where C++ takes the type that it is
// declared with.
template <int bits, bool is_signed, class T>
[[gnu::always_inline]] constexpr auto symreal_width(T const &value) noexcept {
  using Wide = std::conditional_t<is_signed, long long, unsigned long long>;
  if constexpr ((std::is_integral_v<T> || std::is_enum_v<T>) && !detail::is_class<T>) {
    constexpr int unused = 64 - bits;
    static_assert(unused >= 0);
    return static_cast<Wide>(static_cast<unsigned long long>(value) << unused) >> unused;
  } else if constexpr (detail::is_symbolic_int<T>) {
    constexpr int unused = 64 - bits;
    return SymbolicInt<Wide>(SymbolicInt<unsigned long long>(value) << unused) >> unused;
  } else
    return value;
}

// `T x = value;` that a jump passes: C++ has no jump past an initialisation, so the object gets its value behind its
// declaration.
template <class T> class Initialised {
public:
  explicit constexpr Initialised(T &object) noexcept : object_(object) {}
  constexpr void operator=(T const &value) const noexcept { object_ = value; }

private:
  T &object_;
};
template <class T, std::size_t n> class Initialised<T[n]> {
public:
  explicit constexpr Initialised(T (&object)[n]) noexcept : object_(object) {}
  constexpr void operator=(T const (&value)[n]) const noexcept {
    for (std::size_t k = 0; k < n; ++k) Initialised<T>{object_[k]} = value[k];
  }

private:
  T (&object_)[n];
};
template <class T> constexpr Initialised<T> symreal_initialised(T &object) noexcept { return Initialised<T>(object); }

// An array that a jump may pass: a class without constructors, which converts to a pointer to its first element.
template <class Array> struct SymrealArray {
  Array elements;
  constexpr operator std::remove_extent_t<Array> *() noexcept { return elements; }
};

namespace detail {

// The type that C has for what stands for it here: a comparison of REALs, an integer that stays symbolic.
template <class T> struct TypeInC {
  using Type = T;
};
template <class T> struct TypeInC<T const> {
  using Type = typename TypeInC<T>::Type const;
};
template <class T> struct TypeInC<T *> {
  using Type = typename TypeInC<T>::Type *;
};
template <> struct TypeInC<SymbolicBool> {
  using Type = int;
};
template <class T> struct TypeInC<SymbolicInt<T>> {
  using Type = T;
};

// An enumeration is compatible with its integer there, and an array of unknown bound with any.
template <class A, class B> constexpr bool is_compatible() noexcept {
  if constexpr (std::is_same_v<A, B>)
    return true;
  else if constexpr (std::is_enum_v<A> && std::is_integral_v<B>)
    return std::is_same_v<std::underlying_type_t<A>, B>;
  else if constexpr (std::is_enum_v<B> && std::is_integral_v<A>)
    return std::is_same_v<A, std::underlying_type_t<B>>;
  else if constexpr (std::is_array_v<A> && std::is_array_v<B> && (std::extent_v<A> == 0 || std::extent_v<B> == 0))
    return is_compatible<std::remove_extent_t<A>, std::remove_extent_t<B>>();
  else
    return false;
}

} // namespace detail

template <class A, class B> inline constexpr bool symreal_compatible =
    detail::is_compatible<typename detail::TypeInC<std::remove_cv_t<std::remove_reference_t<A>>>::Type,
                          typename detail::TypeInC<std::remove_cv_t<std::remove_reference_t<B>>>::Type>();

// True if an association of _Generic has the controlling expression's type. The default is tested last and matches.
struct SymrealOtherwise {};
template <class Control, bool is_last, class Type> constexpr bool symreal_is_associated() noexcept {
  if constexpr (std::is_same_v<Type, SymrealOtherwise>)
    return is_last;
  else
    return !is_last && detail::is_compatible<typename detail::TypeInC<std::decay_t<Control>>::Type,
                                             typename detail::TypeInC<Type>::Type>();
}

} // namespace symreal

// The associations are pairs of a type and a value here.
#define _Generic(control, ...)                                                                                         \
  ([&]() -> decltype(auto) {                                                                                           \
    using symreal_control = decltype(control);                                                                         \
    SYMREAL_REPEATED(SYMREAL_ASSOCIATIONS(false, __VA_ARGS__))                                                         \
    SYMREAL_REPEATED(SYMREAL_ASSOCIATIONS(true, __VA_ARGS__));                                                         \
  }())
#define SYMREAL_ASSOCIATIONS(is_last, type, value, ...)                                                                \
  if constexpr (::symreal::symreal_is_associated<symreal_control, is_last, type>())                                    \
    return (value);                                                                                                    \
  else                                                                                                                 \
    __VA_OPT__(SYMREAL_ASSOCIATIONS_AGAIN SYMREAL_NO_ARGUMENTS(is_last, __VA_ARGS__))
#define SYMREAL_NO_ARGUMENTS ()
#define SYMREAL_ASSOCIATIONS_AGAIN() SYMREAL_ASSOCIATIONS
#define SYMREAL_REPEATED(...) SYMREAL_THRICE(SYMREAL_THRICE(SYMREAL_THRICE(__VA_ARGS__)))
#define SYMREAL_THRICE(...) SYMREAL_ONCE(SYMREAL_ONCE(SYMREAL_ONCE(__VA_ARGS__)))
#define SYMREAL_ONCE(...) __VA_ARGS__

#ifdef __clang__ // computes in the declared type, in C as well
#define SYMREAL_WIDTH(bits, is_signed, ...) (__VA_ARGS__)
#else
#define SYMREAL_WIDTH(bits, is_signed, ...) (::symreal::symreal_width<bits, is_signed>((__VA_ARGS__)))
#endif

// Both are words of C alone.
#define __builtin_types_compatible_p(...) (::symreal::symreal_compatible<__VA_ARGS__>)
#define __builtin_choose_expr(condition, chosen, ...)                                                                  \
  ([&]() -> decltype(auto) {                                                                                           \
    if constexpr (condition)                                                                                           \
      return (chosen);                                                                                                 \
    else                                                                                                               \
      return (__VA_ARGS__);                                                                                            \
  }())

// Keywords of C, as gcc spells them in C++. `restrict` is dropped: it does not affect values.
#ifndef SYMREAL_BEFORE_C99
#define restrict
#endif
#define _Noreturn __attribute__((__noreturn__))
#define __PRETTY_FUNCTION__ __func__ // without the parameters, which C++ adds
#define _Thread_local thread_local
#define __thread thread_local
#define _Alignof alignof
#define _Alignas alignas
#define _Static_assert static_assert
#define __auto_type auto
