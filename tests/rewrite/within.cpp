// within(b) is range(-b, b).
// RUN: %symreal generate %s -o %t.c --kernel=f --graph %t.graph
// RUN: FileCheck %s --input-file=%t.graph --check-prefix=GRAPH
// RUN: not %rewrite %s -- -DWRONG 2>&1 | FileCheck %s --check-prefix=WRONG
// GRAPH: input "a" {{.*}} range -1.5 1.5 =
// GRAPH: input "b" {{.*}} range -3 3 =
#include <cstdio>
constexpr int reach = 3;
#pragma symreal function input(a) within(1.5) input(b) within(reach) output(return)
double f(double a, double b) { return a * b; }
#ifdef WRONG
// WRONG: within.cpp:[[@LINE+1]]:35: error: within(b) stands after input(...) and has one number [SYM021]
#pragma symreal function input(a) within(-1, 1) output(return)
double g(double a) { return a * a; }
// WRONG: within.cpp:[[@LINE+1]]:26: error: within(b) stands after input(...) and has one number [SYM021]
#pragma symreal function within(1) input(a) output(return)
double h(double a) { return a * a; }
#endif
int main() { std::printf("%g\n", f(0.5, 2)); }
