// Which directions of the original's branches no sample took: in the kernel, in what it calls, in each function made of
// a template, in an operand, in a macro; not in what ran before the kernel, nor in the annotations.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/k.c --decisions=select
// RUN: %symreal verify %s %t/k.c --branches --json > %t/json 2> %t/told
// RUN: grep -v 'always\|: never met$' %t/told | FileCheck %s --check-prefix=TOLD --implicit-check-not "never"
// RUN: FileCheck %s --check-prefix=JSON < %t/json
// TOLD: branches of the original: 15 of 22 directions taken by some sample
// TOLD-NEXT: verify_branches.cpp:[[#@LINE + 38]]:10: never true: x > 100
// TOLD-NEXT: verify_branches.cpp:[[#@LINE + 42]]:7: never false: x < limit, in double capped<40>(double)
// TOLD-NEXT: verify_branches.cpp:[[#@LINE + 49]]:19: never true: x[0] > 50
// TOLD-NEXT: verify_branches.cpp:[[#@LINE + 51]]:7: never true: x[1] > 70
// TOLD-NEXT: verify_branches.cpp:[[#@LINE + 50]]:25: never met: x[0] > 1
// TOLD-NEXT: verify_branches.cpp:[[#@LINE + 50]]:10: never true: LARGE
// JSON: "branches": {
// JSON-NEXT: "directions": 22,
// JSON-NEXT: "taken": 15,
// JSON-NEXT: "counts": [
// JSON: "place": "{{.*}}verify_branches.cpp:{{[0-9]+}}:10",
// JSON-NEXT: "condition": "x > 100",
// JSON-NEXT: "true": 0,
// JSON-NEXT: "false": 2{{[0-9]+}}

// Shards together say the same, and so does a certificate.
// RUN: %symreal verify %s %t/k.c --branches --json --shard 1/2 > %t/1.json
// RUN: %symreal verify %s %t/k.c --branches --json --shard 2/2 > %t/2.json
// RUN: %tool verify --merge %t/1.json %t/2.json 2> %t/joined
// RUN: diff %t/told %t/joined
// RUN: %symreal verify %s %t/k.c --branches --certificate %t/c.json
// RUN: FileCheck %s --check-prefix=JSON < %t/c.json
// RUN: %symreal verify %s %t/k.c --check %t/c.json 2>&1 | FileCheck %s --check-prefix=HOLDS
// HOLDS: branches of the original: 15 of 22
// HOLDS: certificate {{.*}}c.json holds
// RUN: not %tool verify %s %t/k.c --branches --check %t/c.json 2>&1 | FileCheck %s --check-prefix=OPTION
// OPTION: error: --branches has no effect with --check, which does what the certificate says [SYM010]
// Without the option nothing is said.
// RUN: %symreal verify %s %t/k.c 2>&1 | FileCheck %s --check-prefix=WITHOUT --implicit-check-not "branches of"
// WITHOUT: kernel k
#include <cstdio>
#define LARGE(a) ((a) > 90)

// In a callee, which ran with larger numbers before the kernel.
double callee(double x) {
  double y = 1;
  if (x > 0.5)
    y = 2; // both ways
  return x > 100 ? y : -y;
}

// One side in one function of the template, both in the other.
template <int limit> double capped(double x) {
  if (x < limit) x *= 2;
  return x;
}

#pragma symreal function input(x[0:2]) range(-3, 3) output(y[0:6])
void k(double const *x, double *y) {
  for (int i = 0; i < 6; ++i) y[i] = 0;
  y[0] = x[0] > 0 ? 2 : 1;
  if (x[0] < 2 || x[0] > 50) y[1] = x[1];
  y[2] = callee(x[0]) + callee(x[1]);
  y[3] = capped<40>(x[0]) + capped<1>(x[1]);
  if (x[1] > 70) y[4] = x[0] > 1 ? 5 : 6;
  y[5] = LARGE(x[0]) ? 1 : x[1];
}

int main(int argc, char **) {
  if (argc > 7) return 1;
  double x[2] = {0.5, 0.75}, y[6];
  if (callee(200) < 0) return 2;
  k(x, y);
  std::printf("%g\n", y[0]);
  return 0;
}
