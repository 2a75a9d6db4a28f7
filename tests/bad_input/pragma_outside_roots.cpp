// A header outside of the roots is not rewritten, so its pragmas would be overlooked.
// RUN: rm -rf %t && split-file %s %t
// RUN: not %rewrite %t/src/main.cpp -- -I%t/lib 2>&1 | FileCheck %s
// CHECK: lib/energy.h:1:{{[0-9]+}}: error: {{.*}} [SYM029]

//--- lib/energy.h
#pragma symreal function input(v) output(return)
inline double energy(double v) { return 0.5 * v * v; }

//--- src/main.cpp
#include "energy.h"
int main() { return energy(2) > 3; }
