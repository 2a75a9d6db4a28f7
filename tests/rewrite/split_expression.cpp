// A number goes through `...`, but is written half by a macro and half beside it: no conversion fits around it.
// RUN: not %rewrite %s 2>&1 | FileCheck %s
#include <cstdio>
#define AND_HALF_OF , 0.5 *
void print(double x) {
  // CHECK: split_expression.cpp:[[@LINE+1]]:{{[0-9]+}}: error: a macro makes a part of this expression, which needs a conversion [SYM040]
  std::printf("%g\n" AND_HALF_OF x);
}
