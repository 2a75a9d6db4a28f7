/* C has designators in any order, and several at a time; C++ has neither. */
// RUN: not %rewrite %s 2>&1 | FileCheck %s
// RUN: %rewrite %s -- -DGOOD | FileCheck %s --check-prefix=GOOD
struct inner {
  double a, b;
};
struct pair {
  double first, second;
  struct inner in;
};
// GOOD: struct pair good = {.first = 1.0, .in = {.a = 2.0}};
struct pair good = {.first = 1.0, .in = {.a = 2.0}};
// GOOD: REAL table[] = {[0] = 1.0, [1] = 2.0};
double table[] = {[0] = 1.0, [1] = 2.0};
// GOOD: REAL sparse[5] = {REAL_EITHER(([1] =), {}, ) 1.0, REAL_EITHER(([3] =), {}, ) 2.0, 3.0};
double sparse[5] = {[1] = 1.0, [3] = 2.0, 3.0};
#ifndef GOOD
// CHECK: designators.c:[[@LINE+1]]:{{[0-9]+}}: error: C++ has designators in the order of the members, and one at a time [SYM037]
struct pair order = {.second = 1.0, .first = 2.0};
// CHECK: designators.c:[[@LINE+1]]:{{[0-9]+}}: error: C++ has designators in the order of the members, and one at a time [SYM037]
struct pair several = {.in.b = 1.0};
// CHECK: designators.c:[[@LINE+1]]:{{[0-9]+}}: error: C++ has designators in the order of the members, and one at a time [SYM037]
double back[4] = {[2] = 1.0, [1] = 2.0};
#endif
