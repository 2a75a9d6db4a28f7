/* What the recording has baked in is compared with what the caller gives: arguments, members, what `constant` names, text.
   RUN: rm -rf %t && mkdir %t && cd %t
   RUN: %symreal generate %s -o k.c --wrapper --decisions=guard
   RUN: FileCheck %s < k_wrapper.c
   CHECK: if (symreal_same && (long long)(kind) != 3ll) symreal_same = 0;
   CHECK: symreal_text((name)) !=
   DEFINE: %{c} = %cc -std=c99 -Wall -Wextra -pedantic -Werror -Wno-unknown-pragmas
   RUN: cd %t && %{c} k.c k_wrapper.c -lm -o swapped && %{c} %s -lm -o original
   RUN: cd %t && ./original > expected && ./swapped | diff - expected

   `verify` changes each of them, and holds the wrapper to what the kernel is.
   RUN: cd %t && %symreal verify %s k.c --samples=50 --min-samples=5 2>&1 | FileCheck %s --check-prefix=VERIFY
   VERIFY: the wrapper was tried as well
   RUN: cd %t && sed 's/if (symreal_same && (long long)(kind) != 3ll) symreal_same = 0;//' k_wrapper.c > w.c && not diff w.c k_wrapper.c && mv w.c k_wrapper.c
   RUN: cd %t && not %symreal verify %s k.c --samples=50 --min-samples=5 2>&1 | FileCheck %s --check-prefix=OTHER
   OTHER: k_wrapper.c:1:1: error: this wrapper was generated for another form of kernel 'kern' [SYM090]
*/
#include <stdio.h>
#include <string.h>

enum kind { slow, fast = 3 };
struct motor {
  double torque, losses[2];
  int poles, index[2], serial;
};
int order = 2;
double kern(double x, struct motor const *motor, enum kind kind, double gain, char const *name, int depth);

static double repeated(double x, int depth) { return depth > 0 ? repeated(1.5 * x + depth, depth - 1) : x; }

#pragma symreal function input(x, *motor) constant(order, kind, gain, depth) output(return)
double kern(double x, struct motor const *motor, enum kind kind, double gain, char const *name, int depth) {
  double sum = x;
  int k;
  for (k = 0; k < motor->poles; ++k) sum = sum * motor->torque + motor->losses[motor->index[k % 2]];
  if (kind == fast) sum *= gain;
  if (strcmp(name, "reversed") == 0) sum = -sum;
  if (x < 0) return sum;
  return repeated(sum, depth) + order;
}

int main(void) {
  struct motor motor = {2, {0.5, 0.25}, 3, {0, 1}, 7};
#define CALL(...) printf("%.17g\n", kern(__VA_ARGS__))
  CALL(1.5, &motor, fast, 2.5, "plain", 2);
  motor.serial = 8; /* which the kernel does not read */
  CALL(1.25, &motor, fast, 2.5, "plain", 2);
  CALL(1.5, &motor, slow, 2.5, "plain", 2);
  CALL(1.5, &motor, fast, 2.75, "plain", 2);
  CALL(1.5, &motor, fast, 2.5, "reversed", 2);
  CALL(1.5, &motor, fast, 2.5, "plain", 3);
  CALL(-1.5, &motor, fast, 2.5, "plain", 2);
  motor.poles = 2;
  CALL(1.5, &motor, fast, 2.5, "plain", 2);
  motor.poles = 3;
  motor.index[1] = 0;
  CALL(1.5, &motor, fast, 2.5, "plain", 2);
  motor.index[1] = 1;
  order = 5;
  CALL(1.5, &motor, fast, 2.5, "plain", 2);
  return 0;
}
