// Under --decisions=guard the path taken is recorded with its conditions: compute returns the number of the first that
// does not hold. The comparison in `half` is met from two places, each with its own guard.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/g.c --decisions=guard --mainline --json > %t/json 2> %t/table
// RUN: FileCheck %s --check-prefix=C < %t/g.c
// C: /* symreal {{.*}}"guards":3,"decisions":"guard"
// C: int compute(
// C: if (!(input[0] > 0.0)) return 1;
// C: if (input[1] < 1.0) return 2;
// C: if (trunc(t0) != 3.0) return 3;
// C: output[0] =
// C: return 0;
// RUN: FileCheck %s --check-prefix=H < %t/g.h
// H: int compute(
// H: 1 guards.cpp:[[#@LINE + 43]]:3: x > 0{{$}}
// H: 2 guards.cpp:{{[0-9]+}}:3: y < 1 is false{{$}}
// H: 3 guards.cpp:{{[0-9:]+}}: the conversion of (x + y) to int gives 3{{$}}
// H: enum { guard_count = 3 };
// H: char const *guard_text(int guard);
// RUN: FileCheck %s --check-prefix=TABLE < %t/table
// TABLE: guard 1 guards.cpp:{{[0-9:]+}}: x > 0
// RUN: FileCheck %s --check-prefix=JSON < %t/json
// JSON: "guards": [
// JSON: "condition": "x > 0",
// JSON: "file": "{{.*}}guards.cpp",
// JSON-NEXT: "line": [[#@LINE + 32]],
// RUN: %cc -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror %t/g.c %t/g_main.c -lm -o %t/run
// RUN: %clang -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror %t/g.c %t/g_main.c -lm -o %t/run_clang
// RUN: %t/run | FileCheck %s --check-prefix=SAME
// SAME: value_return = 8.5
// RUN: not %t/run -1 2>&1 | FileCheck %s --check-prefix=FIRST
// FIRST: guard 1 does not hold: guards.cpp:{{[0-9:]+}}: x > 0
// RUN: not %t/run_clang 2 0.5 2>&1 | FileCheck %s --check-prefix=SECOND
// SECOND: guard 2 does not hold: guards.cpp:{{[0-9:]+}}: y < 1 is false
// RUN: not %t/run 2.5 3 2>&1 | FileCheck %s --check-prefix=THIRD
// THIRD: guard 3 does not hold: guards.cpp:{{[0-9:]+}}: the conversion of (x + y) to int gives 3
// RUN: %symreal verify %s %t/g.c --json > %t/json 2> %t/table
// RUN: FileCheck %s --check-prefix=PROOF < %t/table
// PROOF: kernel step, mode finite: 1000 samples
// PROOF: refused by a guard: {{[1-9]}}
// PROOF: 1 {{[1-9][0-9]*}} guards.cpp:{{[0-9:]+}}: x > 0
// PROOF: 2 {{[1-9][0-9]*}} guards.cpp:{{[0-9:]+}}: y < 1 is false
// A guard that is missing, wrong, or met too late is a difference.
// RUN: sed 's/return 2;/return 3;/' %t/g.c > %t/other.c
// RUN: python3 %tools/expect_status.py 3 %symreal verify %s %t/other.c 2>&1 | FileCheck %s --check-prefix=OTHER
// OTHER: error: on {{[0-9]+}} samples the code does not return the guard that does not hold [SYM091]
// OTHER: the original does not satisfy the guard y < 1 is false, the code returned guard 3
// RUN: sed 's/if (input[[]1] < 1.0) return 2;//' %t/g.c > %t/none.c
// RUN: python3 %tools/expect_status.py 3 %symreal verify %s %t/none.c
// RUN: sed 's/if (input[[]1] < 1.0)/output[0] = 0.0; if (input[1] < 1.0)/' %t/g.c > %t/writes.c
// RUN: python3 %tools/expect_status.py 3 %symreal verify %s %t/writes.c 2>&1 | FileCheck %s --check-prefix=WRITES
// WRITES: the code returned that guard, but wrote to its outputs
#include <cstdio>

#pragma symreal function input(x, y) output(return)
double step(double x, double y) {
  double result = 0;
  if (x > 0) result += x;
  if (y < 1) result -= 1;
  for (int i = 0; i < (int)(x + y); ++i) result += y;
  return result;
}

int main() {
  std::printf("%g\n", step(1.0, 2.5));
}
