// An original that crashes or exits in its next call, where the recorded one returns, is not one that makes no such call.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/a.c -- -DCRASH && not %symreal verify %s %t/a.c --samples=20 --min-samples=5 -- -DCRASH 2>&1 | FileCheck %s --check-prefix=CRASH
// CRASH: error: signal 8 (Floating point exception) ended the original in its next call's kernel on a sample, where the recorded call returns: it reads something that the recording has baked in, and that the program changes [SYM091]
// RUN: %symreal generate %s -o %t/b.c -- -DEXIT && not %symreal verify %s %t/b.c --samples=20 --min-samples=5 -- -DEXIT 2>&1 | FileCheck %s --check-prefix=EXIT
// EXIT: error: on a sample the original in its next call ended within its kernel, where the recorded call returns:
// RUN: %symreal generate %s -o %t/c.c -- -DENDLESS && not %symreal verify %s %t/c.c --samples=20 --min-samples=5 -- -DENDLESS 2>&1 | FileCheck %s --check-prefix=ENDLESS
// ENDLESS: error: the original in its next call's kernel does not end on a sample within the time limit, where the recorded call returns:
//
// A program that ends on its way there is reported, and the kernel is verified all the same.
// RUN: %symreal generate %s -o %t/d.c -- -DBETWEEN && %symreal verify %s %t/d.c --samples=20 --min-samples=5 -- -DBETWEEN 2>&1 | FileCheck %s --check-prefix=BETWEEN
// BETWEEN: the program's next call was not compared: signal 6 (Aborted) ends the program before it
// RUN: %symreal generate %s -o %t/e.c -- -DSTATUS && %symreal verify %s %t/e.c --samples=20 --min-samples=5 -- -DSTATUS 2>&1 | FileCheck %s --check-prefix=STATUS
// STATUS: the program's next call was not compared: the program ends before it, with status 3
// So is a call whose arguments lead nowhere, while other shapes and the end of the program are a matter of course.
// RUN: %symreal generate %s -o %t/f.c -- -DNULL_OUTPUT && %symreal verify %s %t/f.c --samples=20 --min-samples=5 -- -DNULL_OUTPUT 2>&1 | FileCheck %s --check-prefix=ARGUMENTS
// ARGUMENTS: the program's next call was not compared: its arguments cannot be read
// RUN: %symreal generate %s -o %t/g.c && %symreal verify %s %t/g.c --samples=20 --min-samples=5 2>&1 | FileCheck %s --implicit-check-not="next call"
#include <cstdio>
#include <cstdlib>

static int mode = 1, *const at = &mode;

#ifdef NULL_OUTPUT
static double room;
#pragma symreal function input(x) output(*y)
static void kernel(double x, double *y) {
  if (y) *y = 2 * x;
}
static double call(double *y) {
  kernel(0.5, y);
  return room;
}
int main() {
  double const sum = call(&room);
  std::printf("%g\n", sum + call(nullptr));
}

#else
#pragma symreal function input(x) output(return)
static double kernel(double x) {
#if defined(CRASH)
  return 12 / __atomic_load_n(at, __ATOMIC_RELAXED) * x;
#elif defined(EXIT)
  if (__atomic_load_n(at, __ATOMIC_RELAXED) == 0) std::exit(0);
#elif defined(ENDLESS)
  while (__atomic_load_n(at, __ATOMIC_RELAXED) == 0) {
  }
#endif
  return 2 * x;
}

int main() {
  double const first = kernel(0.5);
  mode = 0;
#if defined(BETWEEN)
  std::abort();
#elif defined(STATUS)
  std::exit(3);
#elif defined(CRASH) || defined(EXIT) || defined(ENDLESS)
  std::printf("%g\n", kernel(1.5));
#endif
  std::printf("%g\n", first);
}
#endif
