// With --paths-met the paths that given samples take become code; a guard refuses each branch that none of them takes, be
// it one between paths or one whose ways come together again. Where samples go both ways, these still come together.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o all.c --decisions=explore --explore=joins=off 2>&1 | FileCheck %s --check-prefix=ALL
// RUN: printf 'x[0],x[1],time,m\n0.5,2,0,3\n-0.5,1,1,3\n\n0.25,1.5,2,3\n' > met.csv
// RUN: %symreal generate %s -o met.c --decisions=explore --paths-met met.csv --json 2> told > json
// RUN: FileCheck %s --check-prefix=MET < told
// RUN: FileCheck %s --check-prefix=JSON < json
// RUN: FileCheck %s --check-prefix=CODE < met.c
// ALL: explored 12 paths, {{[0-9]+}} selects between them; complete: no guards
// MET-NOT: warning
// MET: explored 1 path, 0 selects between them; complete for the paths that samples take: see the guards
// MET-NEXT: the ways from 1 decision came together
// MET-NEXT: paths that 3 given samples take; 1 branch that none takes: a guard each
// MET: guard 1 paths_met.cpp:[[#@LINE+76]]:3: x[0] > 10 is false
// MET-NOT: guard 2
// JSON: "samples": 3,
// JSON-NEXT: "unmet": 1
// CODE: "decisions":"explore:128:64:met={{[0-9a-f]+}}"
// CODE: int compute(
// CODE-NOT: sinh
// CODE: if (t0 > 10.0) return 1;
// CODE: t0 > 0.0 ?
// CODE-NOT: sinh
// CODE: return 0;

// Where each way is a path, no arm is left that no sample takes.
// RUN: %symreal generate %s -o apart.c --decisions=explore --explore=joins=off --paths-met met.csv 2>&1 | FileCheck %s --check-prefix=APART
// RUN: FileCheck %s --check-prefix=STRAIGHT < apart.c
// RUN: %symreal verify %s apart.c --paths-met met.csv --samples=200 --min-samples=20 2>&1 | FileCheck %s --check-prefix=STEPS
// APART: explored 2 paths, 2 selects between them; complete for the paths that samples take: see the guards
// APART-NEXT: paths that 3 given samples take; 4 branches that none takes: a guard each
// APART: guard 1 paths_met.cpp:{{[0-9]+}}:3: x[0] > 10 is false
// APART-NEXT: guard 2 paths_met.cpp:{{[0-9]+}}:23: n < 2 (x[1] > 1) where x[0] > 0
// APART-NEXT: guard 3 paths_met.cpp:{{[0-9]+}}:23: n < 2 ((x[1] / m) > 1) is false where x[0] > 0
// APART-NEXT: guard 4 paths_met.cpp:{{[0-9]+}}:23: n < 2 (x[1] > 1) is false where x[0] > 0 is false
// STRAIGHT: int compute(
// STRAIGHT: /constants[0]
// STRAIGHT-NOT: /constants[0]
// STRAIGHT: return 0;
// STEPS: refused by a guard: {{[1-9]}}
// STEPS: y[0] 3 0 0{{$}}

// Verification needs the table, and tries its samples as well.
// RUN: %symreal verify %s met.c --paths-met met.csv --samples=200 --min-samples=20 2>&1 | FileCheck %s --check-prefix=VERIFIED
// VERIFIED: kernel f, mode finite: 203 samples
// VERIFIED: refused by a guard: {{[1-9]}}
// VERIFIED: y[0] 3 0 0{{$}}
// RUN: sed 's/exp(/exp(1e-9 + /' met.c > wrong.c
// RUN: not %symreal verify %s wrong.c --paths-met met.csv --samples=200 --min-samples=20 2>&1 | FileCheck %s --check-prefix=WRONG
// WRONG: outputs differ from the original [SYM091]
// RUN: not %tool verify %s met.c 2>&1 | FileCheck %s --check-prefix=LACKS
// LACKS: met.c:1:1: error: this file was generated with --paths-met: give verify the same table of samples [SYM003]
// RUN: printf 'x[0],x[1],m\n0.5,2,3\n' > other.csv
// RUN: not %tool verify %s met.c --paths-met other.csv 2>&1 | FileCheck %s --check-prefix=OTHER
// OTHER: other.csv:1:1: error: 'met.c' was generated with another table of samples [SYM195]
// RUN: not %tool verify %s all.c --paths-met met.csv 2>&1 | FileCheck %s --check-prefix=UNUSED
// UNUSED: error: --paths-met has no effect: no generated file had it [SYM010]
// RUN: not %tool generate %s -o no.c --decisions=guard --paths-met met.csv 2>&1 | FileCheck %s --check-prefix=POLICY
// POLICY: error: --paths-met has no effect without --decisions=explore or auto [SYM010]

// What is no table of this kernel is refused, with its place, and nothing is written.
// RUN: printf 'x[0],time\n0.5,2\n' > bad.csv
// RUN: not %tool generate %s -o no.c --decisions=explore --paths-met bad.csv 2>&1 | FileCheck %s --check-prefix=COLUMN
// COLUMN: bad.csv:1:1: error: no column is called 'x[1]', which is one of kernel 'f' [SYM195]
// RUN: printf 'x[0],x[1],x[0]\n0.5,2,2\n' > bad.csv
// RUN: not %tool generate %s -o no.c --decisions=explore --paths-met bad.csv 2>&1 | FileCheck %s --check-prefix=TWICE
// TWICE: bad.csv:1:11: error: a second column is called 'x[0]' [SYM195]
// RUN: printf 'x[0],x[1]\n0.5,2\n0.25, 2m\n' > bad.csv
// RUN: not %tool generate %s -o no.c --decisions=explore --paths-met bad.csv 2>&1 | FileCheck %s --check-prefix=NUMBER
// NUMBER: bad.csv:3:7: error: '2m' is not a finite number [SYM195]
// RUN: printf 'x[0],x[1]\n0.5,2\n0.25\n' > bad.csv
// RUN: not %tool generate %s -o no.c --decisions=explore --paths-met bad.csv 2>&1 | FileCheck %s --check-prefix=SHORT
// SHORT: bad.csv:3:1: error: the line has 1 cells, and the header 2 [SYM195]
// RUN: printf 'x[0],x[1]\n' > bad.csv
// RUN: not %tool generate %s -o no.c --decisions=explore --paths-met bad.csv 2>&1 | FileCheck %s --check-prefix=EMPTY
// EMPTY: bad.csv:1:1: error: there is no line of numbers below a header of names [SYM195]
// RUN: not %tool generate %s -o no.c --decisions=explore --paths-met none.csv 2>&1 | FileCheck %s --check-prefix=NONE
// NONE: error: {{.*}}none.csv{{.*}} [SYM0
// RUN: printf 'x[0],x[1]\n0.5,1e308\n' > bad.csv
// RUN: not %tool generate %s -o no.c --decisions=explore --paths-met bad.csv 2>&1 | FileCheck %s --check-prefix=OUTSIDE
// OUTSIDE: bad.csv:1:1: error: none of the 1 samples lies within the premises of mode finite and the guards of kernel 'f' [SYM196]
// OUTSIDE: note: the kernel is here
// RUN: not ls no.c
#include <cmath>
#include <cstdio>

#pragma symreal function input(x[0:2]) range(-3, 12) parameter(m) output(y[0:3])
void f(double const *x, double m, double *y) {
  y[0] = x[0];
  if (x[0] > 10) { // none
    y[0] = std::sinh(x[0]);
    y[0] *= 2;
  }
  double s = 1;
  if (x[0] > 0) // both
    s = x[1];
  int n = 0;
  double z = x[1];
  while (z > 1 && n < 2) z /= m, ++n; // two of three
  y[1] = std::exp(x[1]) + n;
  y[2] = s * z;
}

int main() {
  double x[2] = {0.5, 2}, y[3];
  f(x, 3, y);
  std::printf("%g\n", y[0]);
}
