// No reference can be bound to a bit-field, so whether it is hidden state is not known.
// RUN: %symreal generate %s -o %t.c 2>&1 | FileCheck %s
#include <cstdio>

struct Options {
  unsigned twice : 1;
};

#pragma symreal function input(x) output(return)
double scale(Options const &options, double x) {
  Options own = {1};
  return options.twice ? 2 * x * own.twice : x + options.twice; // told once
}

int main() { std::printf("%g\n", scale({1}, 0.5)); }

// CHECK: bit_field.cpp:6:12: warning: cannot tell whether 'Options::twice' is hidden state [SYM064]
// CHECK-NOT: SYM064]
