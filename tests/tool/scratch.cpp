// scratch(...): what a kernel leaves in its working memory is not lost; what it reads there first is still hidden state.
// RUN: %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not=SYM0 --implicit-check-not="baked in"
// RUN: %symreal verify %s %t.c --samples=100
// CHECK: kernel solve
// RUN: not %symreal generate %s -o %t.c -- -DREAD_FIRST 2>&1 | FileCheck %s --check-prefix=FIRST
// FIRST: error: kernel 'solve' reads 'matrix[1]' (3), which is neither input nor parameter [SYM017]
// FIRST-NOT: SYM053
#include <cstdio>
#include <vector>

struct Solver {
  double matrix[2];
  std::vector<double> grown;
};

static double work[3];

#pragma symreal function input(x) scratch(solver, work[0:3]) output(return)
double solve(Solver &solver, double x) {
  auto &[matrix, grown] = solver;
  work[0] = x;
  for (int i = 1; i < 3; i++) work[i] = work[i - 1] * x;
  matrix[0] = x;
  grown.resize(100);
  grown[99] = x;
#ifdef READ_FIRST
  x += matrix[1];
#endif
  return work[2] + matrix[0] * grown[99];
}

int main() {
  Solver solver = {{2, 3}, {4}};
  std::printf("%g\n", solve(solver, 0.5));
  std::printf("%g %g %g\n", work[1], solver.matrix[0], solver.grown[99]);
}
