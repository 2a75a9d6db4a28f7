// A function in a namespace that no header declares: the wrapper opens the namespace. Where a guard does not hold it calls the
// original, whose symbol is renamed in its object file.
// RUN: rm -rf %t && mkdir %t && %symreal generate %s -o %t/k.c --wrapper --decisions=guard
// RUN: FileCheck %s < %t/k_wrapper.cpp
// CHECK: objcopy --redefine-sym _ZN5model5inner4kernEd=fallback OBJECT
// CHECK: {{^}}namespace model {
// CHECK-NEXT: {{^}}inline namespace inner {
// CHECK-NEXT: extern "C" double fallback(double x);
// CHECK: {{^}}double kern(double x) {
// RUN: %cc -c %t/k.c -o %t/k.o && %cxx -Wall -Wextra -Werror -c %t/k_wrapper.cpp -o %t/wrapper.o
// RUN: %cxx -DFUNCTION -Wno-unknown-pragmas -c %s -o %t/function.o && %cxx -DMAIN -c %s -o %t/main.o
// RUN: %cxx %t/function.o %t/main.o -o %t/original && %t/original > %t/expected
// RUN: objcopy --redefine-sym _ZN5model5inner4kernEd=fallback %t/function.o
// RUN: %cxx %t/function.o %t/main.o %t/k.o %t/wrapper.o -o %t/swapped && %t/swapped | diff - %t/expected
#include <cstdio>

#if !defined MAIN && !defined FUNCTION
#define MAIN
#define FUNCTION
#endif

namespace model {
inline namespace inner {
#ifdef FUNCTION
#pragma symreal function input(x) output(return)
double kern(double x) { return x > 1 ? x * x : x - 1; }
#else
double kern(double x);
#endif
} // namespace inner
} // namespace model

#ifdef MAIN
int main() { std::printf("%g %g\n", model::kern(2), model::kern(0.5)); }
#endif
