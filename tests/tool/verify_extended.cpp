// Mode fast, where the original itself is off: the recorded graph in extended precision says which of them is.
// RUN: %symreal generate %s -o %t.c --fp=fast --effort=1
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c --kernel square --json > %t.json 2> %t.told
// RUN: FileCheck %s --input-file=%t.told
// RUN: FileCheck %s --check-prefix=JSON --input-file=%t.json
// Code that is worse than the original is refused.
// RUN: sed 's/\(  output.*\);/\1 + 100.0;/' %t.c > %t.worse.c && cp %t.h %t.worse.h
// RUN: not %symreal verify --samples=100 --min-samples=10 %s %t.worse.c 2>&1 | FileCheck %s --check-prefix=WORSE
// In mode finite numbers are equal, and nobody asks.
// RUN: %symreal generate %s -o %t.finite.c && %symreal verify --samples=100 --min-samples=10 %s %t.finite.c 2>&1 | FileCheck %s --check-prefix=FINITE
// What depends on how numbers are stored has no value in extended precision.
// RUN: sed 's/2e8 \* x;/2e8 * x + std::nextafter(x, 1.0);/; s,<cstdio>,<cmath>,; /std::printf/d' %s > %t.single.cpp
// RUN: %symreal generate %t.single.cpp -o %t.single.c --fp=fast --effort=1
// RUN: not %symreal verify --samples=100 --min-samples=10 %t.single.cpp %t.single.c 2>&1 | FileCheck %s --check-prefix=SINGLE
#include <cstdio>

#pragma symreal function input(x) range(0, 1) output(y)
void square(double x, double &y) { y = (1e8 + x) * (1e8 + x) - 1e16 - 2e8 * x; }

int main() {
  double y;
  square(0.5, y);
  std::printf("%g\n", y);
}
// CHECK: judged in 64 bits: {{[0-9]+}} numbers of {{[0-9]+}} calls, which are farther than the tolerance from the original's, but no farther from the exact ones than 4 times the original's and the tolerance
// CHECK-NEXT: y {{ *[0-9]+}} calls: off by at most {{[0-9.]+e-03}}, the original by {{[0-9.]+e[-+]0[0-9]}}
// CHECK: y {{.*}} 0{{$}}
// JSON: "extended": {
// JSON: "bits": 64
// JSON: "original_error":
// WORSE: 1 of 1 outputs differ from the original
// WORSE: in extended precision the original is off by {{.*}}, the generated code by {{.*}}: more than 4 times as far and the tolerance
// FINITE-NOT: judged
// SINGLE: extended precision cannot tell which of them is nearer to the exact value: 'nextafter' is not an operation on real numbers
