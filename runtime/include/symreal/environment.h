// Checks for uses of the environment in a kernel: errno, floating-point flags and modes, library functions. Generated
// code omits these uses. The rewriter puts a check before each; while a kernel is recorded it reports an error at its
// place, or state that is baked in.
#pragma once

namespace symreal {

namespace detail {

extern __thread bool recording; // as in state.h
void error_read(char const *place) noexcept;
void error_written() noexcept;
void environment_used(char const *what, char const *place) noexcept;
void given_from_outside(char const *function, double value) noexcept;

} // namespace detail

// errno is read: an error where a function of a symbolic value may have set it since it was last written.
constexpr void symreal_error_read(char const *, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording) detail::error_read(place);
}
constexpr void symreal_error_written(char const *, char const *) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording) detail::error_written();
}
// `what`: the function and its effect.
constexpr void symreal_environment(char const *what, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording) detail::environment_used(what, place);
}

// Reports the result of a function compiled elsewhere, which is the comma's right operand.
struct Outside {
  char const *function;
  template <class T> constexpr T operator,(T value) const noexcept {
    if (!__builtin_is_constant_evaluated() && detail::recording)
      detail::given_from_outside(function, static_cast<double>(value));
    return value;
  }
};
constexpr Outside symreal_outside(char const *function, char const *) noexcept { return {function}; }

} // namespace symreal
