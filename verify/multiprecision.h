// Numbers of selectable precision with the functions of <cmath>, by the MPFR library, rounded to nearest.
#pragma once

#include <compare>
#include <mpfr.h>

namespace symreal::program {

class Multiprecision {
public:
  // Sets the precision of numbers constructed from now on.
  static void set_bits(unsigned bits) { mpfr_set_default_prec(static_cast<mpfr_prec_t>(bits)); }

  explicit Multiprecision(double value = 0) { mpfr_init_set_d(value_, value, MPFR_RNDN); }
  Multiprecision(Multiprecision const &other) {
    mpfr_init2(value_, mpfr_get_prec(other.value_));
    mpfr_set(value_, other.value_, MPFR_RNDN);
  }
  Multiprecision(Multiprecision &&other) noexcept : Multiprecision() { mpfr_swap(value_, other.value_); }
  Multiprecision &operator=(Multiprecision other) noexcept {
    mpfr_swap(value_, other.value_);
    return *this;
  }
  ~Multiprecision() { mpfr_clear(value_); }

  explicit operator double() const { return mpfr_get_d(value_, MPFR_RNDN); }

  friend bool operator==(Multiprecision const &x, Multiprecision const &y) { return mpfr_equal_p(x.value_, y.value_); }
  friend std::partial_ordering operator<=>(Multiprecision const &x, Multiprecision const &y) {
    if (mpfr_unordered_p(x.value_, y.value_)) return std::partial_ordering::unordered;
    return mpfr_cmp(x.value_, y.value_) <=> 0;
  }
  friend bool operator==(Multiprecision const &x, double y) { return x == Multiprecision(y); }
  friend std::partial_ordering operator<=>(Multiprecision const &x, double y) { return x <=> Multiprecision(y); }

#define SYMREAL_MPFR_UNARY(name, function)                                                                             \
  friend Multiprecision name(Multiprecision const &x) {                                                                \
    Multiprecision result;                                                                                             \
    mpfr_##function(result.value_, x.value_, MPFR_RNDN);                                                               \
    return result;                                                                                                     \
  }
#define SYMREAL_MPFR_INTEGER(name)                                                                                     \
  friend Multiprecision name(Multiprecision const &x) {                                                                \
    Multiprecision result;                                                                                             \
    mpfr_##name(result.value_, x.value_);                                                                              \
    return result;                                                                                                     \
  }
#define SYMREAL_MPFR_BINARY(name, function)                                                                            \
  friend Multiprecision name(Multiprecision const &x, Multiprecision const &y) {                                       \
    Multiprecision result;                                                                                             \
    mpfr_##function(result.value_, x.value_, y.value_, MPFR_RNDN);                                                     \
    return result;                                                                                                     \
  }
  SYMREAL_MPFR_UNARY(operator-, neg)
  SYMREAL_MPFR_BINARY(operator+, add)
  SYMREAL_MPFR_BINARY(operator-, sub)
  SYMREAL_MPFR_BINARY(operator*, mul)
  SYMREAL_MPFR_BINARY(operator/, div)
  SYMREAL_MPFR_UNARY(fabs, abs)
  SYMREAL_MPFR_UNARY(sqrt, sqrt)
  SYMREAL_MPFR_UNARY(cbrt, cbrt)
  SYMREAL_MPFR_UNARY(rint, rint)
  SYMREAL_MPFR_UNARY(sin, sin)
  SYMREAL_MPFR_UNARY(cos, cos)
  SYMREAL_MPFR_UNARY(tan, tan)
  SYMREAL_MPFR_UNARY(asin, asin)
  SYMREAL_MPFR_UNARY(acos, acos)
  SYMREAL_MPFR_UNARY(atan, atan)
  SYMREAL_MPFR_UNARY(sinh, sinh)
  SYMREAL_MPFR_UNARY(cosh, cosh)
  SYMREAL_MPFR_UNARY(tanh, tanh)
  SYMREAL_MPFR_UNARY(asinh, asinh)
  SYMREAL_MPFR_UNARY(acosh, acosh)
  SYMREAL_MPFR_UNARY(atanh, atanh)
  SYMREAL_MPFR_UNARY(exp, exp)
  SYMREAL_MPFR_UNARY(exp2, exp2)
  SYMREAL_MPFR_UNARY(expm1, expm1)
  SYMREAL_MPFR_UNARY(log, log)
  SYMREAL_MPFR_UNARY(log2, log2)
  SYMREAL_MPFR_UNARY(log10, log10)
  SYMREAL_MPFR_UNARY(log1p, log1p)
  SYMREAL_MPFR_UNARY(erf, erf)
  SYMREAL_MPFR_UNARY(erfc, erfc)
  SYMREAL_MPFR_UNARY(tgamma, gamma)
  SYMREAL_MPFR_INTEGER(floor)
  SYMREAL_MPFR_INTEGER(ceil)
  SYMREAL_MPFR_INTEGER(trunc)
  SYMREAL_MPFR_INTEGER(round)
  SYMREAL_MPFR_BINARY(hypot, hypot)
  SYMREAL_MPFR_BINARY(fmin, min)
  SYMREAL_MPFR_BINARY(fmax, max)
  SYMREAL_MPFR_BINARY(fdim, dim)
  SYMREAL_MPFR_BINARY(fmod, fmod)
  SYMREAL_MPFR_BINARY(remainder, remainder)
  SYMREAL_MPFR_BINARY(copysign, copysign)
  SYMREAL_MPFR_BINARY(atan2, atan2)
  SYMREAL_MPFR_BINARY(pow, pow)
#undef SYMREAL_MPFR_UNARY
#undef SYMREAL_MPFR_INTEGER
#undef SYMREAL_MPFR_BINARY

  friend Multiprecision fma(Multiprecision const &x, Multiprecision const &y, Multiprecision const &z) {
    Multiprecision result;
    mpfr_fma(result.value_, x.value_, y.value_, z.value_, MPFR_RNDN);
    return result;
  }
  friend Multiprecision lgamma(Multiprecision const &x) {
    Multiprecision result;
    int sign = 0;
    mpfr_lgamma(result.value_, &sign, x.value_, MPFR_RNDN);
    return result;
  }
  friend Multiprecision logb(Multiprecision const &x) {
    if (mpfr_regular_p(x.value_)) return Multiprecision(static_cast<double>(mpfr_get_exp(x.value_) - 1));
    return log2(fabs(x)); // same poles as logb
  }
  friend Multiprecision nextafter(Multiprecision const &x, Multiprecision const &y) {
    Multiprecision result = x;
    mpfr_nexttoward(result.value_, y.value_);
    return result;
  }
  friend bool signbit(Multiprecision const &x) { return mpfr_signbit(x.value_) != 0; }

private:
  mpfr_t value_;
};

} // namespace symreal::program
