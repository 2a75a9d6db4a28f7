// A pointer of a constant that the kernel names leads to the same constants in every call, as does one that is an argument of
// --kernel.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s --kernel 'value(x=-1..1) -> return' -o %t/value.c && FileCheck %s --input-file=%t/value.c
// RUN: %symreal verify %s --kernel 'value(x=-1..1) -> return' %t/value.c --samples=100
// RUN: %symreal generate %s --kernel 'sum(m=&models[0], x=-1..1) -> return' -o %t/sum.c && FileCheck %s --input-file=%t/sum.c
// RUN: %symreal verify %s --kernel 'sum(m=&models[0], x=-1..1) -> return' %t/sum.c --samples=100
// RUN: not %symreal generate %s --kernel 'sum(m=&models[0], x=-1..1) -> return' -o %t/sum.c --wrapper 2>&1 | FileCheck %s --check-prefix=WRAPPER
// CHECK: = input[0] + 2.0 + (input[0]*3.0 + 4.0);
// WRAPPER: error: --wrapper cannot compare 'm' of 'sum', which is baked in: it leads to constants
typedef struct {
  double slope, level;
} Term;
typedef struct {
  int n;
  const Term *terms;
} Model;
static const Term terms[] = {{1, 2}, {3, 4}};
static const Model models[] = {{2, terms}, {1, terms}};

double sum(const Model *m, double x) {
  double result = 0;
  for (int k = 0; k < m->n; ++k) {
    const Term *term = &m->terms[k];
    result += term->slope * x + term->level;
  }
  return result;
}
double value(double x) { return sum(&models[0], x); }
