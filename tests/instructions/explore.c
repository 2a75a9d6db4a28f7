// Decisions of the instructions are guards, or paths.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: not %symreal generate %s -o code.c --record=instructions 2>&1 | FileCheck %s --check-prefix=ERROR
// ERROR: error: {{.*}} [SYM016]
// RUN: %symreal generate %s -o guard.c --record=instructions --decisions=guard && %symreal verify --samples=100 --min-samples=10 %s guard.c
// RUN: %symreal generate %s -o paths.c --record=instructions --decisions=explore 2>&1 | FileCheck %s --check-prefix=PATHS
// PATHS: explored {{[0-9]+}} path{{s?}}, {{[0-9]+}} selects between them; complete: no guards
// RUN: %symreal verify --samples=100 --min-samples=10 %s paths.c > verified 2>&1 && FileCheck %s --check-prefix=SAME < verified
// SAME: every path is recorded: no sample is left to a guard

static void exchange(double *a, double *b) {
  double const kept = *a;
  *a = *b;
  *b = kept;
}

#pragma symreal function input(x[0:3]) range(-1, 1) output(x[0:3])
void sort(double *x) {
  for (int end = 2; end > 0; --end)
    for (int k = 0; k < end; ++k)
      if (x[k] > x[k + 1]) exchange(x + k, x + k + 1);
}

int main(void) {
  double x[] = {0.3, -0.2, 0.1};
  sort(x);
  return x[0] == 0;
}
