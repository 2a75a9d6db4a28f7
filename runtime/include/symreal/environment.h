// What a kernel asks or tells beside its numbers: errno, the flags and modes of floating-point arithmetic, functions of
// libraries. Generated code has none of it. The rewriter puts these before the expressions that do so; while a kernel
// is recorded they are errors at their place, or told as state that is baked in.
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
// `what`: the function, and what it does.
constexpr void symreal_environment(char const *what, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording) detail::environment_used(what, place);
}

// What a function gives that is compiled elsewhere: the right operand of the comma.
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
