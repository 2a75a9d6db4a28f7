// The order in which operands are evaluated.
//
// g() - h() with the operator of the language calls g first; gcc evaluates the arguments of a call, which the operator
// of a class is, from the last to the first. If it matters the rewriter hands the right operand over as a function.
// And an argument that is a number is read when its turn comes, one that is a class when the function is entered.
#pragma once

#include <symreal/truth.h>

namespace symreal {

namespace types {
template <class Function> struct Later {
  Function evaluate;
};

#define SYMREAL_LATER(op)                                                                                              \
  template <class Left, class Function, class = std::enable_if_t<is_number_or_truth<Left>>>                            \
  [[gnu::always_inline]] inline constexpr auto operator op(Left left, Later<Function> right) {                         \
    return left op right.evaluate();                                                                                   \
  }                                                                                                                    \
  template <class Left, class Function,                                                                                \
            class = std::enable_if_t<!is_number_or_truth<Left> && std::is_convertible_v<Left const &, RealNumber>>,    \
            class = void>                                                                                              \
  [[gnu::always_inline]] inline constexpr auto operator op(Left const &left, Later<Function> right) {                  \
    RealNumber const number = left;                                                                                    \
    return number op right.evaluate();                                                                                 \
  }
SYMREAL_LATER(+)
SYMREAL_LATER(-)
SYMREAL_LATER(*)
SYMREAL_LATER(/)
SYMREAL_LATER(<)
SYMREAL_LATER(<=)
SYMREAL_LATER(>)
SYMREAL_LATER(>=)
SYMREAL_LATER(==)
SYMREAL_LATER(!=)
#undef SYMREAL_LATER
} // namespace types

// Result type of the function: a number by value; an lvalue of any other type as a reference.
template <class T> using later_result =
    std::conditional_t<std::is_lvalue_reference_v<T> && !is_number_or_truth<std::remove_cvref_t<T>>, T,
                       std::remove_cvref_t<T>>;
template <class T>
  requires(!std::is_arithmetic_v<std::remove_cvref_t<T>>)
[[gnu::always_inline]] constexpr later_result<T> symreal_later_value(T &&x) noexcept {
  return static_cast<T &&>(x);
}
// Arithmetic operands, bit-fields included, to which a reference cannot bind.
template <class T>
  requires std::is_arithmetic_v<T>
[[gnu::always_inline]] constexpr T symreal_later_value(T const &x) noexcept {
  return x;
}

// In another instantiation of a template the operand may be of a class, whose operators are calls in the original too.
template <class Function> [[gnu::always_inline]] constexpr decltype(auto) symreal_later(Function function) noexcept {
  using Result = std::remove_cvref_t<decltype(function())>;
  if constexpr (is_number_or_truth<Result> || std::is_convertible_v<Result const &, RealNumber>)
    return types::Later<Function>{function};
  else
    return function();
}

// The value that the object has now; a class is handed over as it is.
[[gnu::always_inline]] constexpr RealNumber symreal_now(RealNumber const &x) noexcept { return x; }
template <class T, class = std::enable_if_t<!std::is_same_v<std::remove_cvref_t<T>, RealNumber>>>
[[gnu::always_inline]] constexpr T &&symreal_now(T &&x) noexcept {
  return static_cast<T &&>(x);
}

} // namespace symreal
