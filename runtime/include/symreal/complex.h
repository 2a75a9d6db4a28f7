// std::complex of RealNumber: computes as std::complex<double>, for which the standard library and the compiler call
// the C library where any other type gets a formula. Functions that are formulas for double too stay with the library.
#pragma once

#include <symreal/complex_function.h>
#include <symreal/library_formulas.h>
#include <symreal/numbers.h>
#include <symreal/real_math.h>
#include <symreal/symbolic_int.h>

#include <complex>
#include <type_traits>

namespace symreal::detail {

using Complex = std::complex<RealNumber>;

struct ComplexParts {
  RealNumber real, imaginary;
};
[[gnu::noinline]] ComplexParts compute_parts(ComplexFunction function, ComplexParts x, ComplexParts y) noexcept;
// A product is a formula under mode finite. Otherwise the compiler recovers infinities if both parts are NaN.
bool products_are_formulas() noexcept;

[[gnu::always_inline]] inline Complex compute(ComplexFunction function, Complex const &x, Complex const &y) noexcept {
  ComplexParts const result = compute_parts(function, {x.real(), x.imag()}, {y.real(), y.imag()});
  return {result.real, result.imaginary};
}

// Compares bits: a compiler may compare ahead of the test for a node, and comparing a node is an invalid operation.
constexpr bool is_nan(RealNumber x) noexcept { return (x.to_bits() & ~(1ull << 63)) > detail::bits(INFINITY); }

[[gnu::always_inline]] inline Complex product(Complex const &x, Complex const &y) noexcept {
  RealNumber const a = x.real(), b = x.imag(), c = y.real(), d = y.imag();
  bool const is_symbolic = a.is_node() || b.is_node() || c.is_node() || d.is_node();
  if (is_symbolic && !products_are_formulas()) return compute(ComplexFunction::multiply, x, y);
  RealNumber const real = a * c - b * d, imaginary = a * d + b * c;
  if (!is_symbolic && is_nan(real) && is_nan(imaginary)) return compute(ComplexFunction::multiply, x, y);
  return {real, imaginary};
}

[[gnu::always_inline]] inline Complex polar(RealNumber radius, RealNumber angle) noexcept {
  return {radius * cos(angle), radius * sin(angle)};
}

// yes() if the condition holds, else no(). Both are computed if it is symbolic.
template <class Yes, class No>
[[gnu::always_inline]] inline Complex select(SymbolicBool condition, Yes yes, No no) noexcept {
  if (!condition.is_symbolic()) return condition.holds() ? yes() : no();
  Complex const y = yes(), z = no();
  return {symreal::select(condition, y.real(), z.real()), symreal::select(condition, y.imag(), z.imag())};
}

// The power with a real exponent or base: the library looks whether the base is a positive number.
[[gnu::always_inline]] inline Complex power(Complex const &x, RealNumber y) noexcept {
  return select((x.imag() == RealNumber(0.0)) & (x.real() > RealNumber(0.0)), [&] { return Complex(pow(x.real(), y)); },
                [&] {
                  Complex const logarithm = compute(ComplexFunction::log, x, x);
                  return polar(exp(y * logarithm.real()), y * logarithm.imag());
                });
}
[[gnu::always_inline]] inline Complex power(RealNumber x, Complex const &y) noexcept {
  return select(
      x > RealNumber(0.0), [&] { return polar(pow(x, y.real()), y.imag() * log(x)); },
      [&] { return compute(ComplexFunction::pow, Complex(x), y); });
}

} // namespace symreal::detail

namespace std {

#define SYMREAL_COMPLEX_ASSIGNMENT(type)                                                                               \
  template <> template <>                                                                                              \
  [[gnu::always_inline]] inline complex<symreal::RealNumber> &complex<symreal::RealNumber>::operator*=(                \
      complex<type> const &z) {                                                                                        \
    return *this = symreal::detail::product(*this, complex(z));                                                        \
  }                                                                                                                    \
  template <> template <>                                                                                              \
  [[gnu::always_inline]] inline complex<symreal::RealNumber> &complex<symreal::RealNumber>::operator/=(                \
      complex<type> const &z) {                                                                                        \
    return *this = symreal::detail::compute(symreal::ComplexFunction::divide, *this, complex(z));                      \
  }
SYMREAL_COMPLEX_ASSIGNMENT(symreal::RealNumber)
SYMREAL_COMPLEX_ASSIGNMENT(float)
SYMREAL_COMPLEX_ASSIGNMENT(double)
SYMREAL_COMPLEX_ASSIGNMENT(long double)
#undef SYMREAL_COMPLEX_ASSIGNMENT

// Explicit specialisations, so that a call that names its type meets them, too.
#define SYMREAL_FORM_infix(id, arity)
#define SYMREAL_FORM_call(id, arity) SYMREAL_COMPLEX_##arity(id)
#define SYMREAL_COMPLEX_1(id)                                                                                          \
  template <> [[gnu::always_inline]] inline complex<symreal::RealNumber> id(complex<symreal::RealNumber> const &z) {   \
    return symreal::detail::compute(symreal::ComplexFunction::id, z, z);                                               \
  }
#define SYMREAL_COMPLEX_2(id)                                                                                          \
  template <> [[gnu::always_inline]] inline complex<symreal::RealNumber> id(complex<symreal::RealNumber> const &x,     \
                                                                            complex<symreal::RealNumber> const &y) {   \
    return symreal::detail::compute(symreal::ComplexFunction::id, x, y);                                               \
  }
#define COMPLEX_FUNCTION(id, arity, form, ...) SYMREAL_FORM_##form(id, arity)
#include <symreal/complex_functions.def>
#undef COMPLEX_FUNCTION
#undef SYMREAL_FORM_infix
#undef SYMREAL_FORM_call
#undef SYMREAL_COMPLEX_1
#undef SYMREAL_COMPLEX_2

template <> [[gnu::always_inline]] inline symreal::RealNumber abs(complex<symreal::RealNumber> const &z) {
  return symreal::hypot(z.real(), z.imag()); // which is what cabs is in the C library
}
template <> [[gnu::always_inline]] inline complex<symreal::RealNumber> proj(complex<symreal::RealNumber> const &z) {
  return symreal::detail::select(
      symreal::isinf(z.real()) | symreal::isinf(z.imag()),
      [&] { return symreal::detail::Complex(INFINITY, symreal::copysign(symreal::RealNumber(0.0), z.imag())); },
      [&] { return z; });
}
template <> [[gnu::always_inline]] inline complex<symreal::RealNumber> pow(complex<symreal::RealNumber> const &x,
                                                                           symreal::RealNumber const &y) {
  return symreal::detail::power(x, y);
}
template <> [[gnu::always_inline]] inline complex<symreal::RealNumber> pow(symreal::RealNumber const &x,
                                                                           complex<symreal::RealNumber> const &y) {
  return symreal::detail::power(x, y);
}

// An int is multiplied out, every other exponent is a number.
template <class T>
  requires symreal::detail::is_symbolic_int<T>
complex<symreal::RealNumber> pow(complex<symreal::RealNumber> const &x, T y) {
  if constexpr (is_same_v<T, symreal::SymbolicInt<int>>) return pow(x, static_cast<int>(y));
  return symreal::detail::power(x, symreal::RealNumber(y));
}
template <class T>
  requires symreal::detail::is_symbolic_int<T>
complex<symreal::RealNumber> pow(T x, complex<symreal::RealNumber> const &y) {
  return symreal::detail::power(symreal::RealNumber(x), y);
}
// The library computes these in long double.
complex<symreal::RealNumber> pow(complex<symreal::RealNumber> const &, long double) = delete;
complex<symreal::RealNumber> pow(long double, complex<symreal::RealNumber> const &) = delete;
complex<symreal::RealNumber> pow(complex<symreal::RealNumber> const &, complex<long double> const &) = delete;
complex<symreal::RealNumber> pow(complex<long double> const &, complex<symreal::RealNumber> const &) = delete;
complex<long double> pow(complex<long double> const &, symreal::RealNumber) = delete;

} // namespace std
