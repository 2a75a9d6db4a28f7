// Type traits of the symbolic types: a REAL answers as double, a comparison as bool.
#pragma once

#include <symreal/real_number.h>

#include <type_traits>

namespace symreal {

namespace detail {
template <class T> struct PlainType {
  using type = T;
};
template <> struct PlainType<SymbolicBool> {
  using type = bool;
};
template <> struct PlainType<SymbolicBool &> {
  using type = bool &;
};
template <> struct PlainType<SymbolicBool const> {
  using type = bool const;
};
template <> struct PlainType<SymbolicBool const &> {
  using type = bool const &;
};
template <> struct PlainType<SymbolicBool &&> {
  using type = bool &&;
};
} // namespace detail
// The type that an expression has in the original.
template <class T> using symreal_plain_type = typename detail::PlainType<T>::type;
// An expression of that type, for an operand that is not evaluated.
template <class T> T symreal_of_type() noexcept;

} // namespace symreal

// As for is_floating_point: these specialisations belong to the standard, and its libraries honour them. A REAL
// converts to an integer, a float or a bool by a cast only; where a template goes on to convert it by itself, that does
// not compile, while the other answer would have sent it another way.
#define SYMREAL_CLASS(type)                                                                                            \
  template <> struct std::is_class<symreal::RealNumber type> : std::false_type {};                                     \
  template <> inline constexpr bool std::is_class_v<symreal::RealNumber type> = false;
#define SYMREAL_CONVERTIBLE(type)                                                                                      \
  template <class T>                                                                                                   \
    requires(std::is_arithmetic_v<T> && !symreal::detail::is_class<T>)                                                 \
  struct std::is_convertible<symreal::RealNumber type, T> : std::true_type {};                                         \
  template <class T>                                                                                                   \
    requires(std::is_arithmetic_v<T> && !symreal::detail::is_class<T>)                                                 \
  inline constexpr bool std::is_convertible_v<symreal::RealNumber type, T> = true;
SYMREAL_CLASS()
SYMREAL_CLASS(const)
SYMREAL_CLASS(volatile)
SYMREAL_CLASS(const volatile)
SYMREAL_CONVERTIBLE()
SYMREAL_CONVERTIBLE(const)
SYMREAL_CONVERTIBLE(&)
SYMREAL_CONVERTIBLE(const &)
SYMREAL_CONVERTIBLE(&&)
SYMREAL_CONVERTIBLE(const &&)
#undef SYMREAL_CLASS
#undef SYMREAL_CONVERTIBLE
