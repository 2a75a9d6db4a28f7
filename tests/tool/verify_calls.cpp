// verify calls the original's kernel several times in a row: what is said to be scratch, and is not, shows then.
// RUN: %symreal generate %s -o %t.c --kernel counted && not %symreal verify %s %t.c 2>&1 | FileCheck %s --check-prefix=COUNTED
// RUN: %symreal generate %s -o %t.c --kernel filtered && %symreal verify %s %t.c 2>&1 | FileCheck %s --check-prefix=FILTERED
// RUN: %symreal generate %s -o %t.c --kernel block && %symreal verify %s %t.c
#include <cstdio>
#include <vector>

struct Filter {
  double level = 0.5;
  std::vector<double> work{1, 2, 3};
  int calls = 1;
};

// COUNTED: error: called again, 1 of 1 outputs differ from the original: it keeps something other than its outputs
// COUNTED: note: value_return: original {{.*}}, generated
#pragma symreal function input(x) constant(f.calls) scratch(f.calls) output(return)
double counted(Filter &f, double x) {
  double const y = x * f.calls;
  f.calls = f.calls + 1;
  return y;
}

// FILTERED: 1000 within the premises
#pragma symreal function input(u, f.level) scratch(f.work) output(f.level)
void filtered(Filter &f, double u) {
  f.work[1] = u - f.level;
  f.level += 0.125 * f.work[1];
  f.level *= 1.5;
}

int main() {
  Filter filter;
  std::printf("%g\n", counted(filter, 1.5));
  filtered(filter, 2.5);
  double s = 2.5, t[2] = {1, 2};
#pragma symreal input(s, t)
  for (double one : t) s += one * s;
#pragma symreal output(s) generate("block.c")
  std::printf("%g %g\n", filter.level, s);
}
