// Compares what generated code has of sines and cosines side by side with the library: within 1e5 the error is measured
// against long double, in units in the last place; beyond the bits are the library's.
#include "angles.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { angles = 5 };

static double error(double value, long double exact) {
  int exponent;
  frexpl(exact, &exponent);
  return (double)(fabsl(value - exact) / ldexpl(1, exponent - 53));
}

static int same(double x, double y) { return x == y ? signbit(x) == signbit(y) : isnan(x) && isnan(y); }

int main(void) {
  double const reach[] = {0.7, 4, 300, 1e5}, far[] = {1.5e5, -1e22, 1e300, INFINITY, NAN};
  double largest = 0;
  srand48(1);
  for (int k = 0; k < 400000; ++k) {
    double x[angles], y[2 * angles];
    for (int i = 0; i < angles; ++i) x[i] = (2 * drand48() - 1) * reach[k % 4];
    x[1] = nearbyint(x[1] / 1.5707963267948966) * 1.5707963267948966; // where sine or cosine is nearly 0
    x[2] *= pow(2, -50 * drand48());
    compute(x, NULL, y);
    for (int i = 0; i < angles; ++i) {
      largest = fmax(largest, error(y[i], sinl(x[i])));
      largest = fmax(largest, error(y[angles + i], cosl(x[i])));
    }
  }
  printf("%s\n", largest > 0.5 && largest < 2.5 ? "near the exact values" : "far from the exact values");
  int others = 0, moved = 0;
  for (int k = 0; k < 5; ++k) {
    double x[angles] = {0.5, 0, -2, 3, 1e5}, y[2 * angles], alone[2 * angles];
    compute(x, NULL, alone);
    x[1] = far[k];
    compute(x, NULL, y);
    others += !same(y[1], sin(far[k])) + !same(y[angles + 1], cos(far[k]));
    for (int i = 0; i < 2 * angles; ++i)
      if (i % angles != 1) moved += fabs(y[i] - alone[i]) > 1e-15;
  }
  printf("%d far angles unlike the library, %d near ones moved by them\n", others, moved);
  return 0;
}
