// Enumerators beside REALs, where the rewriter cannot write their conversion: in a pack, and in templates of which the
// types are not known. A conversion by a class, so that an operator that the program has for its enumeration is the
// better one.
#pragma once

#include <symreal/real_number.h>

namespace symreal::types {

class Enumerator {
public:
  template <class T, std::enable_if_t<std::is_enum_v<T> && std::is_convertible_v<T, double>, int> = 0>
  constexpr Enumerator(T value) noexcept : value_(static_cast<double>(value)) {}
  constexpr RealNumber number() const noexcept { return value_; }

private:
  double value_;
};

template <class T> using IfReal = std::enable_if_t<std::is_same_v<T, RealNumber>, int>;

#define SYMREAL_BESIDE_ENUMERATOR(Result, op)                                                                          \
  template <class T, IfReal<T> = 0> [[gnu::always_inline]] constexpr Result operator op(Enumerator x, T y) noexcept {  \
    return x.number() op y;                                                                                            \
  }                                                                                                                    \
  template <class T, IfReal<T> = 0> [[gnu::always_inline]] constexpr Result operator op(T x, Enumerator y) noexcept {  \
    return x op y.number();                                                                                            \
  }
SYMREAL_BESIDE_ENUMERATOR(RealNumber, +)
SYMREAL_BESIDE_ENUMERATOR(RealNumber, -)
SYMREAL_BESIDE_ENUMERATOR(RealNumber, *)
SYMREAL_BESIDE_ENUMERATOR(RealNumber, /)
SYMREAL_BESIDE_ENUMERATOR(SymbolicBool, <)
SYMREAL_BESIDE_ENUMERATOR(SymbolicBool, <=)
SYMREAL_BESIDE_ENUMERATOR(SymbolicBool, >)
SYMREAL_BESIDE_ENUMERATOR(SymbolicBool, >=)
SYMREAL_BESIDE_ENUMERATOR(SymbolicBool, ==)
SYMREAL_BESIDE_ENUMERATOR(SymbolicBool, !=)
#undef SYMREAL_BESIDE_ENUMERATOR

} // namespace symreal::types
