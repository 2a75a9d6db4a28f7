/* What a solver has found has the derivative of the equations, and not of the steps: Kepler's equation by Newton's method, a
   number, and two equations, an array. First and second derivatives, forward and backward.
   RUN: rm -rf %t && mkdir %t
   RUN: cp %s %t/main.c
   RUN: %symreal generate %t/main.c -o %t/out/ --graph %t/graphs/ 2>&1
   RUN: FileCheck %s --input-file=%t/out/kepler.c
   RUN: FileCheck %s --check-prefix=GRAPH --input-file=%t/graphs/kepler.graph
   RUN: FileCheck %s --check-prefix=TWO --input-file=%t/out/two.c
   RUN: %symreal verify %t/main.c %t/out/kepler.c %t/out/two.c --samples=200 2>&1 | FileCheck %s --check-prefix=PROOF

   Without derivatives the pragma changes nothing.
   RUN: grep -v 'symreal implicit' %s | sed 's/ jacobian.*$//' > %t/bare.c && sed 's/ jacobian.*$//' %s > %t/plain.c
   RUN: %symreal generate %t/plain.c -o %t/plain/ && %symreal generate %t/bare.c -o %t/bare/
   RUN: grep -v '^/' %t/plain/kepler.c > %t/one.txt && grep -v '^/' %t/bare/kepler.c | diff - %t/one.txt

   A residual that is not 0 at what was found is seen.
   RUN: sed 's/double const r = E/double const r = 1.001 * E/' %s > %t/wrong.c
   RUN: %symreal generate %t/wrong.c -o %t/wrong/
   RUN: not %symreal verify %t/wrong.c %t/wrong/kepler.c --samples=200 2>&1 | FileCheck %s --check-prefix=WRONG

   The derivative by e is sin(E) / (1 - e cos(E)): one quotient.
   CHECK: compute(
   CHECK-NOT: symreal
   GRAPH: external {{.}} "implicit function" pure takes input 1 input 1 output 1
   TWO: fabs(
   TWO: ? t
   PROOF: kernel kepler
   PROOF: jacobian_anomaly{{.* 2 .* 0 +[0-9]+ of}}
   PROOF: hessian_anomaly{{.* 4 .* 0 +[0-9]+ of}}
   PROOF: kernel two
   PROOF: jacobian_y_p{{.* 6 .* 0 +[0-9]+ of}}
   PROOF: vjp_y_p{{.* 2 .* 0 +[0-9]+ of}}
   WRONG: note: jacobian_anomaly
*/
#include <math.h>
#include <stdio.h>

#pragma symreal function input(e) range(0.05, 0.6) input(M) range(0.3, 2.5) output(anomaly[0:1]) jacobian(anomaly, [e, M]) hessian(anomaly, [e, M])
void kepler(double e, double M, double *anomaly) {
  double E = M;
  for (int i = 0; i < 8; i++) E = E - (E - e * sin(E) - M) / (1.0 - e * cos(E));
  double const r = E - e * sin(E) - M;
#pragma symreal implicit(E, r)
  anomaly[0] = E;
}

/* x^2 + y^2 = 2 + p0, x y = p1, near (1.4, 0.5); the residual is an expression of its own. */
#pragma symreal function input(p[0:2]) range(0.3, 0.7) output(y[0:3]) jacobian(y, p) vjp(y, p)
void two(double const *p, double *y) {
  double x[2] = {1.5, 0.4}, r[2];
  for (int i = 0; i < 9; i++) {
    double const a = x[0] * x[0] + x[1] * x[1] - 2.0 - p[0], b = x[0] * x[1] - p[1];
    double const determinant = 2.0 * (x[0] * x[0] - x[1] * x[1]);
    double const step = (a * x[0] - b * 2.0 * x[1]) / determinant;
    x[1] -= (2.0 * x[0] * b - x[1] * a) / determinant;
    x[0] -= step;
  }
  r[0] = x[0] * x[0] + x[1] * x[1] - 2.0 - p[0];
  r[1] = x[0] * x[1] - p[1];
#pragma symreal implicit(x[0:2], r[0:2])
  y[0] = x[0];
  y[1] = x[1] * p[0];
  y[2] = sin(x[0]) - x[1];
}

int main(void) {
  double const p[2] = {0.4, 0.5};
  double y[3], anomaly[1];
  kepler(0.3, 1.2, anomaly);
  two(p, y);
  printf("%.17g %.17g %.17g %.17g\n", anomaly[0], y[0], y[1], y[2]);
  return 0;
}
