// A function that cannot be declared again under another name has no wrapper that calls the original.
// RUN: not %symreal generate %s -o %t.c --wrapper --decisions=guard 2>&1 | FileCheck %s
// CHECK: --wrapper calls the original where a guard does not hold, but 'kern' is no plain function
#include <cstdio>

namespace model {
#pragma symreal function input(x) output(return)
double kern(double x) { return x > 1 ? x * x : x - 1; }
} // namespace model

int main() { std::printf("%g\n", model::kern(2)); }
