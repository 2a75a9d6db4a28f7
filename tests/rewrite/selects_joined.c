// `&&` and `||` of plain truth values stay what they are. Those of REALs become `&` and `|`, which bind tighter, so the
// plain ones stand in parentheses there.
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %symreal generate %s -o %t_guard.c --decisions=guard
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t_guard.c
// RUN: %symreal generate %s -o %t_select.c --decisions=select
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t_select.c
// RUN: FileCheck %s --check-prefix=SELECT < %t_select.c
#pragma symreal function input(x[0:3]) range(-4, 4) constant(n, m) output(y[0:4])
void joined(const double *x, double *y, int n, int m) {
  double a = x[0], b = x[1], c = x[2], s = b;
  // CHECK: REAL_IF((s), a > 1 REAL_OR REAL_PLAIN(n > 2 && m > 3)) s = 1;
  if (a > 1 || n > 2 && m > 3) s = 1;
  y[0] = s;
  // CHECK: REAL_COND(REAL_PLAIN(n > 2 && m > 1) REAL_OR c > 0) REAL_THEN b REAL_ELSE 2 REAL_END
  y[1] = n > 2 && m > 1 || c > 0 ? b : 2;
  // CHECK: REAL_IF((s), a > 1 REAL_AND (n > 2 || m > 1)) s = 3;
  if (a > 1 && (n > 2 || m > 1)) s = 3;
  y[2] = s;
  // CHECK: REAL_IF((s), REAL_PLAIN(n > 0 && m > 0) REAL_AND a < 3 REAL_OR REAL_PLAIN(m > 5 && n > 5 && n > 7)) s += a;
  if (n > 0 && m > 0 && a < 3 || m > 5 && n > 5 && n > 7) s += a;
  y[3] = s;
}
// SELECT: ? 1.0 : input[1]
int main(void) {
  double x[3] = {2, 0.5, 1.5}, y[4];
  joined(x, y, 1, 2);
  return 0;
}
