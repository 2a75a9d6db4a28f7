// What cannot be a select stays as it is, and the token that is in the way is named.
// RUN: %rewrite --refusals %s | FileCheck %s
// RUN: %rewrite %s | FileCheck --check-prefix=TEXTCHECK %s
// RUN: %same %s
#include <cassert>
#include <cmath>
#include <cstdio>
#include <cstdlib>

struct Counter { double value; int count; Counter() : value(0), count(0) {} void add(double x) { value += x; ++count; } };
// TEXTCHECK: #define LARGER(a, b) ((a) > (b) ? (a) : (b))
#define LARGER(a, b) ((a) > (b) ? (a) : (b))
// CHECK: refused.cpp:[[@LINE+1]]:11 {{.*}} a use of its macro outside of functions or in a constant expression
int table[LARGER(2, 3)];
double deep(double x) { return x > 0 ? deep(x - 1) : 0; }
// CHECK: refused.cpp:[[@LINE-1]]:32 to line [[@LINE-1]]: a call of 'deep', which calls itself at {{.*}}:[[@LINE-1]]:40
static double total;
double sum(double x) { total += x; return total; }

// TEXTCHECK-NOT: REAL_IF
// TEXTCHECK-NOT: REAL_COND
double all(double x, double *a, Counter &c, int n, double *&p) {
  double *q = a;
  // CHECK: refused.cpp:[[@LINE+1]]:7 to line [[@LINE+1]]: an assignment to 'n', which is not a REAL at {{.*}}:[[@LINE+1]]:14
  if (x > 0) n = 3;
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} a call of 'printf', whose body is not seen here at {{.*}}:[[@LINE+1]]:14
  if (x > 0) std::printf("%g\n", x);
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} a call of 'rand', whose body is not seen here
  if (x > 0) x = std::rand();
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} a call of 'sum', which has an assignment to 'total', which is not its own ({{.*}}
  if (x > 0) x = sum(x);
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} a call of 'add', which has an assignment to 'value', which is not its own
  if (x > 0) c.add(x);
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} an assignment to 'q', which is not a REAL
  if (x > 0) q = a + 1;
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} an assignment to 'a[k]', which depends on a variable of the arm
  if (x > 0) for (int k = 0; k < n; ++k) a[k] = x;
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} an index that depends on a REAL at {{.*}}:[[@LINE+1]]:
  if (x > 0) a[(int)x] = 1;
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} 'throw'
  if (x < 0) throw 1;
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} 'new'
  if (x < 0) p = new double[3];
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} a static variable
  if (x < 0) { static int calls = 0; ++calls; }
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} an assignment through 'r', a reference of the arm
  if (x < 0) { double &r = a[1]; r = 2; }
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} the right side of '&&', which must not be evaluated early at {{.*}}:[[@LINE+1]]:13
  if (n < 4 && a[n] > 0) x = 1;
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} '&&' of a number that stands for a truth value; compare it with 0
  if (x && a[0] > 0) x = 1;
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} a condition that is more than comparisons joined by &&, || and !
  if ((x > 0) == (n > 0)) x = 1;
  for (int k = 0; k < n; ++k)
    // CHECK: refused.cpp:[[@LINE+1]]:9 {{.*}} 'break'; #pragma symreal loop(N) before the loop makes it an exit at {{.*}}:[[@LINE+1]]:19
    if (a[k] > x) break;
  // CHECK: refused.cpp:[[@LINE+1]]:10 {{.*}} a loop; #pragma symreal loop(N) bounds how often it runs
  while (x > 10) x /= 2;
  // CHECK: refused.cpp:[[@LINE+1]]:27 {{.*}} a '?:' that stands for an object, not for its value
  const double &smaller = x < a[0] ? x : a[0];
  // CHECK: refused.cpp:[[@LINE+1]]:11 {{.*}} a '?:' that is not a number but int
  int k = x > 0 ? 1 : 2;
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} an assignment to 'a[0]' within '?:'
  x = x > 0 ? (a[0] = 1) : 2;
  // CHECK: refused.cpp:[[@LINE+1]]:{{.*}} an argument that a macro turns into text
  assert((x > 0 ? x : 1) > 0);
  return smaller + k;
}
// The macro is also an array's bound.
// CHECK: refused.cpp:[[@LINE+1]]:{{.*}} a use of its macro outside of functions or in a constant expression
double larger(double x) { return LARGER(x, 1.0); }
// CHECK: refused.cpp:[[@LINE+1]]:42 {{.*}} a constexpr function
constexpr double half(double x) { return x > 0 ? x / 2 : 0; }
// What would be cut off shows.
double shows(double x, double *out) {
  // CHECK: refused.cpp:[[@LINE+1]]:7 {{.*}} 'return' before an assignment to '*out', which is not its own at {{.*}}:[[@LINE+2]]:3
  if (x < 0) return 0;
  *out = x;
  return x;
}
// CHECK: refused.cpp:[[@LINE+1]]:30 {{.*}} 'return' at {{.*}}:[[@LINE+1]]:37
int chosen(double x) {   if (x < 0) return 1; return 2; }
