// Integers made of a number have their types: unsigned ones wrap, and operands of mixed signs are converted as the
// language says.
// RUN: rm -rf %t && mkdir %t
// RUN: %same %s
// RUN: %symreal generate %s --decisions=select --mainline -o %t/k.c && FileCheck %s --input-file=%t/k.c
// RUN: %symreal verify %s %t/k.c --samples=500
// RUN: %symreal generate %s --decisions=select --fp=fast -o %t/f.c && %symreal verify %s %t/f.c --samples=500
// What the program prints as it was, the symbolic program prints, and the generated code computes, here and elsewhere.
// RUN: %cxx -w %s -o %t/original && %symreal-c++ -w %s -o %t/symbolic && env SYMREAL_REQUEST=decisions=select %t/symbolic | tail -n 12 > %t/printed
// RUN: %t/original 5.3 9.1 > %t/expected && diff %t/expected %t/printed
// RUN: %cc -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror %t/k.c %t/k_main.c -lm -o %t/run
// RUN: %t/run 5.3 9.1 | diff %t/expected -
// RUN: %t/original 7.9 2.5 > %t/expected && %t/run 7.9 2.5 | diff %t/expected -
// RUN: %t/original -3.2 0.5 > %t/expected && %t/run -3.2 0.5 | diff %t/expected -
#include <cstddef>
#include <cstdio>
#include <cstdlib>

// CHECK: static double mul_uint32(double x, double y) {
// CHECK: (double)(uint32_t)(int64_t)
#pragma symreal function input(x[0:2]) range(-20, 20) output(y[0:12])
void k(double const *x, double *y) {
  unsigned u = (unsigned)x[0], n = (unsigned)x[1];
  int i = (int)x[0];
  y[0] = u - 7;
  y[1] = u - 7 < 0 ? 1.5 : 2.5;
  y[2] = u * 3000000000u;
  y[3] = -u * 0.5;
  y[4] = (i - n) / 2;
  y[5] = i - 8 < sizeof(double) ? 1.5 : 2.5;
  y[6] = (unsigned)(i - 6) < 4u ? 1.5 : 2.5;
  y[7] = (size_t)x[0] - 6 > 2 ? 1.5 : 2.5;
  y[8] = (short)(i * 10000);
  unsigned v = i;
  v -= 9;
  --v;
  y[9] = v + i * 49 / 49; // 49 * (1.0 / 49) is less than 1
  y[10] = i > n ? 1.5 : 2.5;
  y[11] = (i + n) % 7 + (u << 30) + (~u >> 3);
}

int main(int count, char **arguments) {
  double x[2] = {5.3, 9.1}, y[12] = {};
  for (int i = 1; i < count; ++i) x[i - 1] = atof(arguments[i]);
  k(x, y);
  for (int i = 0; i < 12; ++i) printf("y[%d] = %.17g\n", i, y[i]);
}
