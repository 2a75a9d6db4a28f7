// Kernels of one source that call each other: verify builds one program with the wrappers of all, and runs that of one
// kernel at a time. A kernel is recorded in its first call outside others, also where the others are not asked for.
// RUN: rm -rf %t && mkdir %t && cd %t && cp %s nested.cpp
// RUN: %symreal generate nested.cpp -o . --wrapper
// RUN: %symreal verify nested.cpp inner.c outer.c --samples=60 --json > both.json
// RUN: grep -c '"wrapped"' both.json | FileCheck %s --check-prefix=BOTH
// RUN: %symreal verify nested.cpp inner.c --samples=60
// RUN: %symreal verify nested.cpp outer.c --samples=60 --json | grep -c '"wrapped"' | FileCheck %s --check-prefix=ONE
// BOTH: {{^}}2{{$}}
// ONE: {{^}}1{{$}}
#include <cmath>

#pragma symreal function input(x) constant(power) output(return)
double inner(double x, int power) {
  double y = 1;
  for (int i = 0; i < power; ++i) y *= x;
  return y;
}

#pragma symreal function input(x) constant(power) output(return)
double outer(double x, int power) { return std::sin(x) + inner(x, power + 1) + inner(x, power); }

int main() { return outer(0.5, 2) > 10 || inner(0.5, 5) > 10; }
