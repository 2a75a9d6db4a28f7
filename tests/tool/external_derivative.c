/* Functions of a library that have functions for their derivatives: a number of numbers, arrays, an integer that does not
   count, one that is returned. Forward, backward and twice.
   RUN: rm -rf %t && mkdir %t
   RUN: split-file %S/Inputs/external_derivative.txt %t
   RUN: %cc -std=c99 -O1 -c %t/library.c -o %t/library.o && ar rcs %t/liblaws.a %t/library.o
   RUN: cp %s %t/main.c
   RUN: %symreal generate %t/main.c -o %t/k.c --graph %t/k.graph --link "-L%t -llaws"
   RUN: FileCheck %s --input-file=%t/k.c
   RUN: FileCheck %s --check-prefix=GRAPH --input-file=%t/k.graph
   RUN: %cc -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror -O1 -ffp-contract=off -I%t %t/use.c %t/k.c -L%t -llaws -lm -o %t/use
   RUN: %t/use
   RUN: %symreal verify %t/main.c %t/k.c --link "-L%t -llaws" --samples=100 2>&1 | FileCheck %s --check-prefix=PROOF
   RUN: %symreal generate %t/main.c -o %t/k.cpp --lang=cpp --fp=fast --link "-L%t -llaws"
   RUN: %symreal verify %t/main.c %t/k.cpp --link "-L%t -llaws" --samples=100 2>&1 | FileCheck %s --check-prefix=PROOF

   A derivative that is wrong in the library is found.
   RUN: sed 's/exp(-x) + 2/1e-6 + exp(-x) + 2/' %t/library.c > %t/wrong.c && %cc -std=c99 -O1 -c %t/wrong.c -o %t/wrong.o
   RUN: not %symreal verify %t/main.c %t/k.c --link %t/wrong.o --samples=100 2>&1 | FileCheck %s --check-prefix=WRONG

   CHECK: void law_jacobian(double, double, double *);
   CHECK: law_jacobian(
   CHECK-NOT: = law(
   GRAPH-DAG: external {{.}} "law" pure returns number takes number number derivative "law_jacobian" derivative "law_hessian"
   GRAPH-DAG: derivative returned "slope"
   PROOF: 100 samples, 100 within
   PROOF: jacobian_y_x{{.* 12 .* 0 +[1-9][0-9]* of 100}}
   PROOF: hessian_cost_x{{.* 9 .* 0 +[1-9][0-9]* of 100}}
   WRONG: error: {{.*}}derivative
*/
#include "laws.h"
#include <stdio.h>
#pragma symreal external(law) pure derivative(law_jacobian, law_hessian)
#pragma symreal external(smooth) pure derivative(slope, bend)
#pragma symreal external(bend3) pure input(v[0:n]) output(out[0:2]) derivative(bend3_jacobian)

#pragma symreal function input(x[0:3]) range(0.2, 1.5) output(y[0:4], cost[0:1]) jacobian(y, x) hessian(cost, x) vjp(y, x)
void model(double const *x, double *y, double *cost) {
  double v[3] = {x[0] * x[1], x[2], x[0]}, out[2];
  bend3(3, v, 2, out);
  y[0] = law(x[0] * x[2], x[1]);
  y[1] = smooth(x[1]) * x[0];
  y[2] = out[0] + x[2];
  y[3] = out[1] * y[0];
  cost[0] = law(x[0], x[1] * x[2]) * smooth(x[2] + x[0]);
}

int main(void) {
  double const x[3] = {0.5, 0.7, 1.1};
  double y[4], cost[1];
  model(x, y, cost);
  for (int i = 0; i < 4; i++) printf("%.17g\n", y[i]);
  printf("%.17g\n", cost[0]);
  return 0;
}
