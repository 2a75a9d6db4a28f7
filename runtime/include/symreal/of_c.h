// What C means by an expression where C++ would give it another type. Each leaves what it does not concern as it is:
// the text may be a macro's, which is compiled with other types as well.
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

// What an operand becomes as an rvalue: an array a pointer.
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
// REALs, by a decision, unless only its size is asked for.
template <class C, class T> [[gnu::always_inline]] constexpr auto symreal_of_c(T const &value) noexcept {
  using From = std::remove_cv_t<T>;
  if constexpr (detail::is_narrow<From> || std::is_enum_v<From> || std::is_same_v<From, SymbolicBool>)
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

// Of _Generic: is it the type of the controlling expression's value? The default is looked at last.
struct SymrealOtherwise {};
template <class Control, bool is_last, class Type> constexpr bool symreal_is_associated() noexcept {
  bool const is_default = std::is_same_v<Type, SymrealOtherwise>;
  return is_last ? is_default : !is_default && std::is_same_v<std::decay_t<Control>, Type>;
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

// Words of C, as gcc has them in C++. What `restrict` promises to the compiler means nothing for the values.
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
