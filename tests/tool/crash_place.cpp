// A program that is ended by a signal while it records itself: the line where it stood, and the calls that led there.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
// RUN: not %symreal generate %s -o %t.c --run-args deep 2>&1 | FileCheck %s --check-prefix=DEEP
// RUN: not %symreal generate %s -o %t.c --run-args abort 2>&1 | FileCheck %s --check-prefix=ABORT
#include <cstdio>
#include <cstdlib>
#include <cstring>

static double const *volatile nothing = nullptr;

// CHECK: crash_place.cpp:[[@LINE+2]]:{{[0-9]+}}: error: signal 11 (Segmentation fault) ended the program before it reached the end of kernel 'f'; it stood here [SYM007]
// CHECK: crash_place.cpp:[[@LINE+13]]:{{[0-9]+}}: note: called from f(double)
static double read(double x) { return x + *nothing; }
// DEEP: crash_place.cpp:[[@LINE+1]]:{{[0-9]+}}: error: signal 11 (Segmentation fault) ended the program
static double deep(double x, char *page) { char more[4096]; std::memset(more, *page, sizeof more); return deep(x + 1, more) + more[7]; }

static char const *how = "";
// ABORT: crash_place.cpp:[[@LINE+6]]:{{[0-9]+}}: error: signal 6 (Aborted) ended the program
#pragma symreal function input(x) output(return)
double f(double x) {
  char page[1] = {0};
  if (std::strcmp(how, "deep") == 0) return deep(x, page);
  if (std::strcmp(how, "abort") == 0)
    std::abort();
  return read(x) + 1;
}

int main(int argc, char **argv) {
  if (argc > 1) how = argv[1];
  std::printf("%g\n", f(1));
}
