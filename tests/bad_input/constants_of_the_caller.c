// The same in C, where a structure is copied without a word, and a literal may be an object without a name.
// RUN: rm -rf %t && mkdir %t
// RUN: not %symreal generate %s -o %t/ 2>&1 | FileCheck %s --implicit-check-not="error:"
// RUN: not ls %t/*
#include <stdio.h>
#include <string.h>

static const double low[3] = {1, 2, 3}, high[3] = {4, 5, 6};
static const double *const literal = (const double[]){7, 8};
struct table {
  const double *begin;
};

#pragma symreal function input(x) output(return)
double copied(const struct table *one, struct table other, const struct table *moved, double x) {
  struct table mine = *one, theirs;
  memcpy(&theirs, moved, sizeof theirs);
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'copied' reads 'mine.begin[0]' (1), which is neither input nor parameter [SYM017]
  double y = x * mine.begin[0];
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'copied' reads 'other.begin[1]' (5), which is neither input nor parameter [SYM017]
  y += other.begin[1];
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'copied' reads 'theirs.begin[0]' (7), which is neither input nor parameter [SYM017]
  return y + theirs.begin[0];
}

static double horner(const double *c, int n, double x) {
  double y = 0;
  for (int k = 0; k < n; ++k) y = y * x + c[k];
  return y;
}

#pragma symreal function input(x) output(return)
double handed_on(const double *c, double x) {
  // CHECK-DAG: :[[#@LINE-6]]:{{[0-9]+}}: error: kernel 'handed_on' reads 'c[k]' (7, 8), which are neither input nor parameter [SYM017]
  return horner(c, 2, x);
}

// Tables that the kernel itself names may be handed on, and read in any way.
#pragma symreal function input(x) output(return)
double its_own(double x) {
  const double *tables[] = {low, high};
  struct table mine = {low}, copy = mine;
  return horner(tables[0], 3, x) + horner(high, 2, x) + copy.begin[2] * horner(literal, 2, x);
}

int main(void) {
  double x = 0.5;
  struct table one = {low}, two = {high}, three = {literal};
  printf("%g\n", copied(&one, two, &three, x) + handed_on(literal, x) + its_own(x));
  return 0;
}
