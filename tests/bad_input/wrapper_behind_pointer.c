// A wrapper compares what a clause names, not the constants that a pointer of it leads to: the next call may pass others.
// RUN: rm -rf %t && mkdir %t
// RUN: not %symreal generate %s -o %t/ --wrapper 2>&1 | FileCheck %s --implicit-check-not=error:
// RUN: %symreal generate %s -o %t/
// RUN: %symreal generate %s --kernel named -o %t/named.c --wrapper
#include <stdio.h>

typedef struct {
  int n;
  const double *p;
} Model;
static const double low[] = {1, 2}, high[] = {3, 4};
static const Model models[] = {{2, low}, {2, high}};

static double sum(int n, const double *p, double x) {
  double result = 0;
  for (int k = 0; k < n; ++k) result = result * x + p[k];
  return result;
}

// CHECK: :[[#@LINE+1]]:44: error: --wrapper cannot compare 'm' of 'to_object', which is baked in: it leads to constants: name those as well, as in constant(p[0:n]) [SYM095]
#pragma symreal function input(x) constant(m) output(return)
double to_object(const Model *m, double x) { return sum(m->n, m->p, x); }

// CHECK: :[[#@LINE+1]]:44: error: --wrapper cannot compare '*m' of 'of_object', which is baked in: it leads to constants: name those as well, as in constant(p[0:n]) [SYM095]
#pragma symreal function input(x) constant(*m) output(return)
double of_object(Model *m, double x) { return sum(m->n, m->p, x); }

// CHECK: :[[#@LINE+1]]:44: error: --wrapper cannot compare 'm' of 'in_copy', which is baked in: it leads to constants: name those as well, as in constant(p[0:n]) [SYM095]
#pragma symreal function input(x) constant(m) output(return)
double in_copy(Model m, double x) { return sum(m.n, m.p, x); }

#pragma symreal function input(x) constant(*m, m->p[0:2]) output(return)
double named(Model *m, double x) { return sum(m->n, m->p, x); }

int main(void) {
  Model mine = {2, low}, other = {2, high};
  printf("%g\n", to_object(&models[1], 0.5) + of_object(&mine, 0.5) + in_copy(other, 0.5) + named(&mine, 0.5));
  return 0;
}
