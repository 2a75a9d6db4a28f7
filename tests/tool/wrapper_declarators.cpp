// The wrapper takes names and types of parameters from the declaration, whatever its form: default arguments, arrays,
// references, pointers to functions, parameters without a name.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/k.c --wrapper --prefix=k --decisions=guard 2>/dev/null
// RUN: FileCheck %s < %t/k_wrapper.cpp
// CHECK: double k_fallback(double x, double g, int n, const double (&v)[2], double w[2], double (*law)(double), long symreal_argument_6, char c);
// CHECK: {{^}}double kern(double x, double g, int n, const double (&v)[2], double w[2], double (*law)(double), long symreal_argument_6, char c) {
// CHECK: return k_fallback(x, g, n, v, w, law, symreal_argument_6, c);
// RUN: %cxx -DFUNCTION -Dkern=k_fallback -c %s -o %t/original.o
// RUN: %cc -c %t/k.c -o %t/k.o && %cxx -c %t/k_wrapper.cpp -o %t/wrapper.o
// RUN: %cxx -DMAIN %s %t/k.o %t/wrapper.o %t/original.o -o %t/swapped
// RUN: %cxx -DMAIN -DFUNCTION %s -o %t/original
// RUN: %t/original > %t/expected && %t/swapped | diff - %t/expected
#include <cstdio>

#if !defined MAIN && !defined FUNCTION
#define MAIN
#define FUNCTION
#endif

double kern(double x, double g = 9.81, int n = 3, double const (&v)[2] = *new double[1][2]{{1, 2}},
            double w[2] = nullptr, double (*law)(double) = nullptr, long = (1, 2), char c = ',');

#ifdef FUNCTION
#pragma symreal function input(x) parameter(g) constant(n, c) output(return)
double kern(double x, double g, int n, double const (&v)[2], double w[2], double (*law)(double), long, char c) {
  if (x > 1) return x * g + c;
  return law ? law(x) : x - g + n + v[1] + (w ? w[0] : 0);
}
#endif

#ifdef MAIN
static double twice(double x) { return 2 * x; }

int main() {
  double const v[2] = {3, 4};
  std::printf("%.17g %.17g\n", kern(2.5), kern(2.5, 1.5, 4, v));
  double w[2] = {5, 6};
  std::printf("%.17g %.17g %.17g\n", kern(0.5), kern(0.5, 1.5, 4, v, w), kern(0.5, 1, 2, v, w, twice));
}
#endif
