// stream.operator<<(x): what prints a REAL is no member.
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: env SYMREAL_ROOTS=%S %symreal-c++ %s -o %t.exe && %t.exe | FileCheck %s --check-prefix=PRINTED
// PRINTED: 1.522.51.53
#include <iostream>

template <class T> static void fill(std::ostream *out, T const &x) {
  // CHECK: out->operator<<(REAL_VALUE(x));
  out->operator<<(x);
}

int main() {
  double x = 1.5;
  int n = 2;
  std::ostream *const out = &std::cout;
  // CHECK: out->operator<<(REAL_VALUE({{.*}}x{{.*}}));
  out->operator<<(x);
  out->operator<<(n);
  std::cout.operator<<(2.5);
  fill(&std::cout, x);
  fill(&std::cout, 3);
}
