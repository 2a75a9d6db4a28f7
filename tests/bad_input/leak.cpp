// Symbolic values in code that was not rewritten: a compiled library, and a header outside the roots. No type tells, since
// they go there as addresses of anything. All are reported in one run, and each goes on with the value it has.
// REQUIRES: x86_64-linux
// RUN: rm -rf %t && mkdir %t && cp %S/Inputs/plain.h %t
// RUN: %cc -O1 -g -c %S/Inputs/plain.c -o %t/plain.o
// RUN: not %symreal generate %s -o %t/leak.c --link="%t/plain.o -lm" --run-on -- -I%t > %t/log 2>&1
// RUN: FileCheck %s --implicit-check-not=error: < %t/log
// RUN: not ls %t/leak.c
// RUN: not %symreal generate %s -o %t/leak.c --cxx clang++-19 --link="%t/plain.o -lm" --run-on -- -I%t > %t/log 2>&1
// RUN: FileCheck %s --implicit-check-not=error: < %t/log

#include <cstdio>
#include <plain.h>

extern "C" {
int plain_less(void const *a, void const *b);
int plain_truncate(void const *a);
long plain_round(void const *a);
void plain_larger(void const *a, void *result);
void plain_distance(void const *a, void *result);
void plain_root(void const *a, void *result);
void plain_float(void const *a, void *result);
void plain_sum(void const *a, void *result);
}

int main() {
  double x[2] = {0.5, 2.25}, y[5];
#pragma symreal input(x[0:2])
  void const *p = &x[0], *q = &x[1];
  void *to[5] = {&y[0], &y[1], &y[2], &y[3], &y[4]};

  std::printf("%d ", plain_less(p, q));
  std::printf("%d ", plain_truncate(q));
  std::printf("%ld ", plain_round(q));
  plain_larger(q, to[0]);
  plain_distance(q, to[1]);
  plain_root(q, to[2]);
  plain_float(p, to[3]);
  plain_sum(p, to[4]);
  std::printf("%d\n", plain_is_positive(p));

  for (double v : y) std::printf("%g ", v);
  for (double &v : y) v *= x[0];
#pragma symreal output(y[0:5]) generate("leak.c")
}

// CHECK: program| 1 2 2 1
// CHECK-NEXT: program| 2.25 3.25 1.5 0.5 2.75
// CHECK: leak.cpp:[[@LINE-17]]:{{[0-9]+}}: error: code that was not rewritten computes with {{.*}}x[0]{{.*}} (met 1 time) [SYM055]
// CHECK: Inputs/plain.c:4:{{[0-9]+}}: note: here, in plain_less
// CHECK: leak.cpp:[[@LINE-18]]:{{[0-9]+}}: error: {{.*}} computes with x[1] (met 1 time) [SYM055]
// CHECK: Inputs/plain.c:5:{{[0-9]+}}: note: here, in plain_truncate
// CHECK: leak.cpp:[[@LINE-19]]:{{[0-9]+}}: error: {{.*}} computes with x[1] (met 1 time) [SYM055]
// CHECK: Inputs/plain.c:6:{{[0-9]+}}: note: here, in plain_round
// CHECK: leak.cpp:[[@LINE-20]]:{{[0-9]+}}: error: {{.*}} computes with x[1] (met 1 time) [SYM055]
// CHECK: Inputs/plain.c:7:{{[0-9]+}}: note: here, in plain_larger
// CHECK: leak.cpp:[[@LINE-21]]:{{[0-9]+}}: error: {{.*}} computes with x[1] (met 1 time) [SYM055]
// CHECK: Inputs/plain.c:8:{{[0-9]+}}: note: here, in plain_distance
// CHECK: leak.cpp:[[@LINE-22]]:{{[0-9]+}}: error: {{.*}} computes with x[1] (met 1 time) [SYM055]
// CHECK: Inputs/plain.c:9:{{[0-9]+}}: note: here, in plain_root
// CHECK: leak.cpp:[[@LINE-23]]:{{[0-9]+}}: error: {{.*}} computes with x[0] (met 1 time) [SYM055]
// CHECK: Inputs/plain.c:10:{{[0-9]+}}: note: here, in plain_float
// CHECK: leak.cpp:[[@LINE-24]]:{{[0-9]+}}: error: {{.*}} computes with x[0] (met 1 time) [SYM055]
// CHECK: Inputs/plain.c:14:{{[0-9]+}}: note: here, in plain_sum
// CHECK: leak.cpp:[[@LINE-26]]:{{[0-9]+}}: error: {{.*}} computes with x[1] (met 1 time) [SYM055]
// CHECK: Inputs/plain.c:14:{{[0-9]+}}: note: here, in plain_sum
// CHECK: leak.cpp:[[@LINE-27]]:{{[0-9]+}}: error: {{.*}} computes with x[0] (met 1 time) [SYM055]
// CHECK: plain.h:10:{{[0-9]+}}: note: here, in plain_is_positive
