// The format of a standard stream is state of the whole program: a kernel that reads it bakes it in, and one that changes it has
// an effect that generated code does not have.
// RUN: rm -rf %t && not %symreal generate %s -o %t/ -- -DREADS 2>&1 | FileCheck %s --check-prefix=READS
// RUN: not %symreal generate %s -o %t/ -- -DSETS 2>&1 | FileCheck %s --check-prefix=SETS
// RUN: not ls %t
// Text alone is left out.
// RUN: %symreal generate %s -o %t.c -- -DPRINTS 2>&1 | FileCheck %s --allow-empty --implicit-check-not="[SYM"
// RUN: %symreal verify %s %t.c --samples=20 -- -DPRINTS 2>&1 | FileCheck %s --check-prefix=PRINTS
// PRINTS: outside of the program: the original writes to standard output, and the generated code does not
// The recording does not see these; verify does.
// RUN: %symreal generate %s -o %t.c -- -DREADS_LATER && not %symreal verify %s %t.c --samples=20 -- -DREADS_LATER 2>&1 | FileCheck %s --check-prefix=READS_LATER
// READS_LATER: error: called again, 1 of 1 outputs differ from the original{{.*}} [SYM091]
// RUN: %symreal generate %s -o %t.c -- -DSETS_LATER && not %symreal verify %s %t.c --samples=20 -- -DSETS_LATER 2>&1 | FileCheck %s --check-prefix=SETS_LATER
// SETS_LATER: error: kernel 'set': the original changes the format of 'std::cerr', and the generated code does not [SYM215]
// A format that is allowed to be baked in stays what it is.
// RUN: mkdir %t && %symreal generate %s -o %t/ --frozen=allow -- -DREADS && %symreal verify %s %t/digits.c %t/ready.c --samples=20 -- -DREADS
#include <iomanip>
#include <iostream>

#if defined(READS)
// READS-DAG: streams_outside.cpp:[[@LINE+2]]:{{[0-9]+}}: error: kernel 'digits' reads 'std::cout.precision()' (6), which is neither input nor parameter [SYM017]
#pragma symreal function input(x) output(return)
static double digits(double x) { return x * std::cout.precision(); }
// READS-DAG: streams_outside.cpp:[[@LINE+3]]:{{[0-9]+}}: error: kernel 'ready' reads 'std::cin.good()' (1), which is neither input nor parameter [SYM017]
#pragma symreal function input(x) output(return)
static double ready(double x) {
  return std::cin.good() ? x : 2 * x;
}
int main() { return digits(0.5) + ready(0.5) > 50; }

#elif defined(SETS)
// SETS-DAG: streams_outside.cpp:[[@LINE+1]]:1: error: the kernel changes the format of 'std::cout', and the generated code would not do so [SYM215]
#pragma symreal function input(x) output(return)
static double set(double x) {
  std::cout.precision(3);
  return 2 * x;
}
// SETS-DAG: streams_outside.cpp:[[@LINE+1]]:1: error: the kernel changes the format of 'std::clog', and the generated code would not do so [SYM215]
#pragma symreal function input(x) output(return)
static double logged(double x) {
  std::clog << std::fixed << 1.5 << "\n";
  return 2 * x;
}
int main() { return set(0.5) + logged(0.5) > 50; }

#elif defined(PRINTS)
#pragma symreal function input(x) output(return)
static double shown(double x) {
  std::cout << std::setw(8) << "here\n";
  return 2 * x;
}
int main() { return shown(0.5) > 50; }

#else
#pragma symreal function input(x) output(return)
static double set(double x) {
  double y = 2 * x;
#if !defined(MBD_SYMBOLIC) && defined(READS_LATER)
  y += static_cast<double>(std::cout.precision() - 6);
#elif !defined(MBD_SYMBOLIC)
  std::cerr << std::setfill('.');
#endif
  return y;
}
int main() { return set(0.5) > 50; }
#endif
