// Memory that a kernel writes before it reads it is no hidden state, wherever it is; what is left there is scratch.
// RUN: %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not=SYM017 --implicit-check-not="baked in"
// RUN: %symreal verify %s %t.c --samples=100
// CHECK: kernel solve
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <vector>

static double work[3];

struct Solver {
  double matrix[2][2];
  std::vector<double> right, left;
  double *buffer;

  double solve(double x) {
    for (auto &row : matrix)
      for (double &element : row) element = 1.0;
    std::fill(right.begin(), right.end(), 2.0);
    left.assign(2, 3.0);
    std::memset(buffer, 0, 2 * sizeof(double));
    work[0] = 4.0;
    for (int i = 1; i < 3; i++) work[i] = work[i - 1] + 1.0;
    double sum = x * work[2] + buffer[1];
    for (int i = 0; i < 2; i++)
      for (int j = 0; j < 2; j++) sum += matrix[i][j] * right[j] * left[i];
    return sum;
  }
};

#pragma symreal function input(x) scratch(work, solver, solver.buffer[0:2]) output(return)
double solve(Solver &solver, double x) { return solver.solve(x); }

int main() {
  double buffer[2] = {5, 6};
  Solver solver{{}, {1, 2}, {3, 4}, buffer};
  std::printf("%g\n", solve(solver, 0.5));
}
