// Statements stand so that few values live at once: a product comes just before the sum that reads it last, and the
// sine and the cosine of one angle stand together, first. Where all values find room in registers, the order is that
// of the source.
//
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/many.c -- -DN=24
// RUN: FileCheck %s --check-prefix=MANY < %t/many.c
// RUN: %cc -std=c99 -Wall -Wextra -pedantic -Werror -ffp-contract=off -O2 -c %t/many.c -o %t/many.o
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t/many.c -- -DN=24 2>&1 | FileCheck %s --check-prefix=SAME
// RUN: %symreal generate %s -o %t/few.c -- -DN=5
// RUN: FileCheck %s --check-prefix=FEW < %t/few.c
//
// MANY: double const [[C:.*]] = cos(input[0]);
// MANY-NEXT: double const [[S:.*]] = sin(input[0]);
// MANY-NEXT: double const t2 = input[0]*input[24];
// MANY-COUNT-4: double const t{{[0-9]}} = input[{{[1-4]}}]*input[{{[0-9]+}}];
// MANY-NEXT: double const t7 = t2*(t2 + 1.0)
// MANY-SAME: t6*(t6 + 1.0);
// MANY-NEXT: double const t8 = input[5]*input[29];
// SAME: z[0] 2 0 0{{$}}
// FEW: double const t0 = input[0]*input[5];
// FEW: double const sum =
// FEW: = cos(input[0]);
// FEW: = sin(input[0]);
#include <cmath>

#pragma symreal function input(x[0 : N], y[0 : N]) output(z[0 : 2])
void kernel(double const *x, double const *y, double *z) {
  double product[N], sum = 0;
  for (int i = 0; i < N; ++i) product[i] = x[i] * y[i];
  for (int i = 0; i < N; ++i) sum += product[i] * (product[i] + 1);
  double const c = std::cos(x[0]), s = std::sin(x[0]);
  z[0] = sum * c * c;
  z[1] = sum + s * s;
}

int main() {
  double x[N], y[N], z[2];
  for (int i = 0; i < N; ++i) {
    x[i] = 0.5 + i;
    y[i] = 1.5 - i;
  }
  kernel(x, y, z);
}
