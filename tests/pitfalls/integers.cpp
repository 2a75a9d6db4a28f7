// A number that becomes an integer which selects what is executed: an index, a switch, a bound of a loop. Each is a
// decision at its place, and under guards a condition that holds the path.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
// RUN: %symreal generate %s -o %t.c --decisions=guard 2>&1 | FileCheck %s --check-prefix=GUARD
// RUN: %symreal verify --samples=100 %s %t.c --min-samples 1
#include <cmath>
#include <cstdio>

static double twice(double x) { return 2.0 * x; }
static double square(double x) { return x * x; }
static double (*const laws[2])(double) = {twice, square};

#pragma symreal function input(x) range(0.1, 1.9) output(return)
double pick(double x) {
  // CHECK-DAG: integers.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: {{.*}}floor(x)
  double y = laws[static_cast<int>(std::floor(x))](x);
  // CHECK-DAG: integers.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: {{.*}}x
  switch ((int)(2.0 * x)) {
  case 3: y += 1.0; break;
  default: y -= 1.0;
  }
  long const n = std::lround(x);
  // CHECK-DAG: integers.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the program decides on a symbolic value: {{.*}}round(x)
  for (long i = 0; i < n; i++) y *= x;
  return y;
}

int main() { std::printf("%g\n", pick(1.75)); }

// GUARD: guard 1 {{.*}}integers.cpp:18:
// GUARD: guard 2 {{.*}}integers.cpp:20:
