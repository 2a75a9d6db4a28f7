// A recording that outgrows the memory ends with a diagnostic; nothing is written.
// RUN: rm -f %t.c && not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <sys/resource.h>

int main() {
  constexpr rlim_t megabytes = 300;
  rlimit const limit = {megabytes << 20, megabytes << 20};
  setrlimit(RLIMIT_AS, &limit);
  double x = 0.5;
#pragma symreal input(x)
  double y = x;
  for (long i = 0; i < 100000000; i++) y = y * x + 0.5;
#pragma symreal output(y) generate("y.c")
}

// CHECK: out_of_memory.cpp:14:{{[0-9]+}}: error: the recording outgrows the memory: the system gives no more after {{[0-9]+}} operations [SYM171]
// CHECK: help:
