// Assembly and intrinsics work on the bytes of a double.
// RUN: not %rewrite %s 2>&1 | FileCheck %s
double halved(double x) {
  double y = 0;
  unsigned low = 0;
  // CHECK: assembly.cpp:[[@LINE+2]]:{{[0-9]+}}: error: a REAL is an operand of assembly [SYM031]
  // CHECK: assembly.cpp:[[@LINE+1]]:{{[0-9]+}}: error: a REAL is an operand of assembly [SYM031]
  __asm__("# %0 %1" : "=m"(y) : "m"(x));
  // CHECK-NOT: assembly.cpp:[[@LINE+1]]
  __asm__("# %0" : "+r"(low));
  return y + low;
}
