// An integer that the system gives is in no source: each recording has its own.
// RUN: not %symreal oracle %s 2>&1 | FileCheck %s --check-prefixes=CHECK,ERROR
// CHECK: operations of the oracle whose values the recorded graph does not have, at 1 lines:
// CHECK-NEXT: hidden_integer.c:[[@LINE+5]]: 1
// ERROR: hidden_integer.c:[[@LINE+3]]:54: error: kernel 'scaled': the oracle gives value_return = {{.*}}, on 1000 of 1000 samples [SYM201]
#include <unistd.h>

#pragma symreal function input(x) range(1, 2) output(return)
double scaled(double x) { return x * (double)getpid(); }

int main(void) { return scaled(1.5) == 0; }
