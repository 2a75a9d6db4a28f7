// A wrapper compares the elements of a table that constant(...) names, where the caller gives another one, or none.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o k.c --kernel poly --wrapper 2>&1 | FileCheck %s --implicit-check-not="error:"
// CHECK: wrote k_wrapper.c
// RUN: FileCheck %s --check-prefix=TEXT --input-file=k_wrapper.c
// TEXT: int symreal_same = 1;
// TEXT-NEXT: if (symreal_same && (unsigned long long)!!((p)) != 1ull) symreal_same = 0;
// TEXT-NEXT: if (symreal_same && (unsigned long long)!!((p->table)) != 1ull) symreal_same = 0;
// TEXT-NEXT: if (symreal_same) {
// RUN: %cc -c k.c && %cc k_wrapper.c k.o -o swapped && %cc %s -o original && ./original > expected && ./swapped | diff - expected
// RUN: %symreal verify %s k.c --kernel poly --samples=50 2>&1 | FileCheck %s --check-prefix=TRIED
// TRIED: the wrapper was tried as well
// A pointer alone is enough for generated code, where it leads to constants, and not for a wrapper.
// RUN: %symreal generate %s -o l.c --kernel poly -- -DPOINTER && %symreal verify %s l.c --kernel poly --samples=50 -- -DPOINTER
// RUN: not %symreal generate %s -o l.c --kernel poly --wrapper -- -DPOINTER 2>&1 | FileCheck %s --check-prefix=POINTER
// POINTER: error: --wrapper cannot compare 'p->table' of 'poly', which is baked in: it leads to constants: name those as well, as in constant(p[0:n]) [SYM095]
#include <stdio.h>

static const double low[3] = {1, 2, 3}, high[3] = {4, 5, 6};
struct poly {
  const double *table;
  int n;
};

#ifdef POINTER
#pragma symreal function constant(p->table, p->n) input(x) output(return)
#else
#pragma symreal function constant(p->table, p->table[0:3], p->n) input(x) output(return)
#endif
double poly(const struct poly *p, double x) {
  double y = 0;
  if (!p) return -1;
  if (!p->table) return -2;
  for (int k = 0; k < p->n; ++k) y = y * x + p->table[k];
  return y;
}

int main(void) {
  struct poly one = {low, 3}, two = {high, 3}, none = {0, 3};
  double equal[3] = {1, 2, 3};
  struct poly same = {equal, 3};
  printf("%g", poly(&one, 0.5));
  printf(" %g", poly(&two, 0.5));
  printf(" %g %g %g\n", poly(&same, 0.25), poly(&none, 0.5), poly(0, 0.5));
  return 0;
}
