/* <tgmath.h> as Symreal reads it: overloaded functions, as in C++, to which the program is translated. Compilers use
   macros instead, which hide the calls from the rewriter. No program is compiled with this header. */
#pragma once

#include <complex.h>
#include <math.h>

#define SYMREAL_OVERLOAD static __attribute__((overloadable, unused))

/* One argument of any type and the others fixed. An integer counts as a double. */
#define SYMREAL_GENERIC(result, f, ...)                                                                                \
  SYMREAL_OVERLOAD result(float) f(float __VA_ARGS__);                                                                 \
  SYMREAL_OVERLOAD result(long double) f(long double __VA_ARGS__);                                                     \
  SYMREAL_OVERLOAD result(double) f(int __VA_ARGS__);                                                                  \
  SYMREAL_OVERLOAD result(double) f(unsigned __VA_ARGS__);                                                             \
  SYMREAL_OVERLOAD result(double) f(long __VA_ARGS__);                                                                 \
  SYMREAL_OVERLOAD result(double) f(unsigned long __VA_ARGS__);                                                        \
  SYMREAL_OVERLOAD result(double) f(long long __VA_ARGS__);                                                            \
  SYMREAL_OVERLOAD result(double) f(unsigned long long __VA_ARGS__);
#define SYMREAL_SAME(type) type
#define SYMREAL_INT(type) int
#define SYMREAL_LONG(type) long
#define SYMREAL_LONG_LONG(type) long long
#define SYMREAL_UNARY(f) SYMREAL_GENERIC(SYMREAL_SAME, f)
#define SYMREAL_UNARY_COMPLEX(f)                                                                                       \
  SYMREAL_UNARY(f)                                                                                                     \
  SYMREAL_OVERLOAD double _Complex f(double _Complex);

/* Two arguments: the result has the wider of their types. */
#define SYMREAL_BINARY(f)                                                                                              \
  SYMREAL_OVERLOAD float f(float, float);                                                                              \
  SYMREAL_OVERLOAD double f(double, float);                                                                            \
  SYMREAL_OVERLOAD double f(float, double);                                                                            \
  SYMREAL_OVERLOAD long double f(long double, long double);                                                            \
  SYMREAL_OVERLOAD long double f(long double, double);                                                                 \
  SYMREAL_OVERLOAD long double f(double, long double);                                                                 \
  SYMREAL_OVERLOAD long double f(long double, float);                                                                  \
  SYMREAL_OVERLOAD long double f(float, long double);                                                                  \
  SYMREAL_WITH_INTEGER(f, int)                                                                                         \
  SYMREAL_WITH_INTEGER(f, unsigned)                                                                                    \
  SYMREAL_WITH_INTEGER(f, long)                                                                                        \
  SYMREAL_WITH_INTEGER(f, unsigned long)                                                                               \
  SYMREAL_WITH_INTEGER(f, long long)                                                                                   \
  SYMREAL_WITH_INTEGER(f, unsigned long long)
#define SYMREAL_WITH_INTEGER(f, integer)                                                                               \
  SYMREAL_OVERLOAD double f(double, integer);                                                                          \
  SYMREAL_OVERLOAD double f(integer, double);                                                                          \
  SYMREAL_OVERLOAD double f(float, integer);                                                                           \
  SYMREAL_OVERLOAD double f(integer, float);                                                                           \
  SYMREAL_OVERLOAD long double f(long double, integer);                                                                \
  SYMREAL_OVERLOAD long double f(integer, long double);                                                                \
  SYMREAL_OVERLOAD double f(integer, int);                                                                             \
  SYMREAL_OVERLOAD double f(integer, unsigned);                                                                        \
  SYMREAL_OVERLOAD double f(integer, long);                                                                            \
  SYMREAL_OVERLOAD double f(integer, unsigned long);                                                                   \
  SYMREAL_OVERLOAD double f(integer, long long);                                                                       \
  SYMREAL_OVERLOAD double f(integer, unsigned long long);

SYMREAL_UNARY_COMPLEX(acos)
SYMREAL_UNARY_COMPLEX(acosh)
SYMREAL_UNARY_COMPLEX(asin)
SYMREAL_UNARY_COMPLEX(asinh)
SYMREAL_UNARY_COMPLEX(atan)
SYMREAL_UNARY_COMPLEX(atanh)
SYMREAL_UNARY_COMPLEX(cos)
SYMREAL_UNARY_COMPLEX(cosh)
SYMREAL_UNARY_COMPLEX(exp)
SYMREAL_UNARY_COMPLEX(log)
SYMREAL_UNARY_COMPLEX(sin)
SYMREAL_UNARY_COMPLEX(sinh)
SYMREAL_UNARY_COMPLEX(sqrt)
SYMREAL_UNARY_COMPLEX(tan)
SYMREAL_UNARY_COMPLEX(tanh)
SYMREAL_UNARY(cbrt)
SYMREAL_UNARY(ceil)
SYMREAL_UNARY(erf)
SYMREAL_UNARY(erfc)
SYMREAL_UNARY(exp2)
SYMREAL_UNARY(expm1)
SYMREAL_UNARY(fabs)
SYMREAL_UNARY(floor)
SYMREAL_UNARY(lgamma)
SYMREAL_UNARY(log10)
SYMREAL_UNARY(log1p)
SYMREAL_UNARY(log2)
SYMREAL_UNARY(logb)
SYMREAL_UNARY(nearbyint)
SYMREAL_UNARY(rint)
SYMREAL_UNARY(round)
SYMREAL_UNARY(tgamma)
SYMREAL_UNARY(trunc)
SYMREAL_OVERLOAD double fabs(double _Complex);
SYMREAL_BINARY(atan2)
SYMREAL_BINARY(copysign)
SYMREAL_BINARY(fdim)
SYMREAL_BINARY(fmax)
SYMREAL_BINARY(fmin)
SYMREAL_BINARY(fmod)
SYMREAL_BINARY(hypot)
SYMREAL_BINARY(nextafter)
SYMREAL_BINARY(pow)
SYMREAL_BINARY(remainder)
SYMREAL_OVERLOAD double _Complex pow(double _Complex, double _Complex);
SYMREAL_OVERLOAD float fma(float, float, float);
SYMREAL_OVERLOAD double fma(float, float, double);
SYMREAL_OVERLOAD double fma(float, double, float);
SYMREAL_OVERLOAD double fma(float, double, double);
SYMREAL_OVERLOAD double fma(double, float, float);
SYMREAL_OVERLOAD double fma(double, float, double);
SYMREAL_OVERLOAD double fma(double, double, float);
SYMREAL_OVERLOAD long double fma(long double, long double, long double);
SYMREAL_OVERLOAD float remquo(float, float, int *);
SYMREAL_OVERLOAD double remquo(float, double, int *);
SYMREAL_OVERLOAD double remquo(double, float, int *);
SYMREAL_OVERLOAD long double remquo(long double, long double, int *);
SYMREAL_GENERIC(SYMREAL_SAME, frexp, , int *)
SYMREAL_GENERIC(SYMREAL_SAME, ldexp, , int)
SYMREAL_GENERIC(SYMREAL_SAME, nexttoward, , long double)
SYMREAL_GENERIC(SYMREAL_SAME, scalbln, , long)
SYMREAL_GENERIC(SYMREAL_SAME, scalbn, , int)
SYMREAL_GENERIC(SYMREAL_INT, ilogb)
SYMREAL_GENERIC(SYMREAL_LONG, lrint)
SYMREAL_GENERIC(SYMREAL_LONG, lround)
SYMREAL_GENERIC(SYMREAL_LONG_LONG, llrint)
SYMREAL_GENERIC(SYMREAL_LONG_LONG, llround)
