// Under --decisions=explore every path through a kernel is recorded, and the code has selects between them: no guard is
// left, and verification has no sample that the code refuses.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/ --decisions=explore --explore=joins=off --json > %t/json 2> %t/table
// RUN: FileCheck %s --check-prefix=TABLE < %t/table
// TABLE-NOT: warning
// TABLE: kernel sort5:
// TABLE: explored 120 paths, {{[0-9]+}} selects between them; complete: no guards
// TABLE: [[#]] decisions on these paths followed from earlier ones
// TABLE: kernel solve:
// TABLE: explored 8 paths, 18 selects between them; complete: no guards
// TABLE: kernel descend:
// TABLE: explored 8 paths, 7 selects between them; complete: no guards
// TABLE: kernel machine:
// TABLE: explored {{[0-9]+}} paths, {{[0-9]+}} selects between them; complete: no guards
// RUN: FileCheck %s --check-prefix=JSON < %t/json
// JSON: "exploration": {
// JSON: "paths": 120,
// JSON: "complete": true
// RUN: FileCheck %s --check-prefix=C < %t/descend.c
// C: /* symreal {"kernel":"descend",{{.*}}"decisions":"explore:128:64:apart"
// C: void compute(
// RUN: cd %t && %symreal verify %s sort5.c solve.c descend.c machine.c > %t/verified 2>&1
// RUN: FileCheck %s --check-prefix=SAME < %t/verified
// SAME: kernel sort5, mode finite: 1000 samples and 60 around decisions, 1060 within the premises
// SAME-NEXT: every path is recorded: no sample is left to a guard
// SAME: y[0] 5 0 0{{$}}
// SAME: kernel solve, mode finite: 1000 samples and 36 around decisions, 1036 within the premises
// SAME: every path is recorded: no sample is left to a guard
// SAME: x[0] 3 0 0{{$}}
// SAME: kernel descend, mode finite: 1000 samples and 42 around decisions, 1042 within the premises
// SAME: every path is recorded: no sample is left to a guard
// SAME-NEXT: decisions: 7 of 7 went both ways
// SAME: value_return 1 0 0{{$}}
// SAME: kernel machine, mode finite: 1000 samples and 48 around decisions, 1048 within the premises
// SAME: every path is recorded: no sample is left to a guard
// SAME: value_return 1 0 0{{$}}
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#pragma symreal function input(x[0:5]) output(y[0:5])
void sort5(double const *x, double *y) {
  for (int i = 0; i < 5; ++i) y[i] = x[i];
  std::sort(y, y + 5);
}

// With partial pivoting: rows are exchanged, and an integer says which.
#pragma symreal function input(A[0:3][0:3], b[0:3]) output(x[0:3])
void solve(double const A[3][3], double const b[3], double x[3]) {
  double m[3][3], r[3];
  for (int i = 0; i < 3; ++i) {
    r[i] = b[i];
    for (int j = 0; j < 3; ++j) m[i][j] = A[i][j];
  }
  for (int k = 0; k < 3; ++k) {
    int pivot = k;
    for (int i = k + 1; i < 3; ++i)
      if (std::fabs(m[i][k]) > std::fabs(m[pivot][k])) pivot = i;
    if (pivot != k) {
      std::swap(m[k], m[pivot]);
      std::swap(r[k], r[pivot]);
    }
    for (int i = k + 1; i < 3; ++i) {
      double f = m[i][k] / m[k][k];
      for (int j = k; j < 3; ++j) m[i][j] -= f * m[k][j];
      r[i] -= f * r[k];
    }
  }
  for (int i = 2; i >= 0; --i) {
    double s = r[i];
    for (int j = i + 1; j < 3; ++j) s -= m[i][j] * x[j];
    x[i] = s / m[i][i];
  }
}

// A kd-tree of two coordinates, in the order of its levels: the leaf's value.
static double const split[7] = {0.5, 0.25, 0.75, 0.1, 0.4, 0.6, 0.9};
static double const leaf[8] = {1, 2, 4, 8, 16, 32, 64, 128};
#pragma symreal function input(p[0:2]) range(0, 1) output(return)
double descend(double const *p) {
  int node = 0;
  for (int depth = 0; node < 7; ++depth) node = 2 * node + (p[depth % 2] < split[node] ? 1 : 2);
  return leaf[node - 7] * p[0];
}

enum class State { idle, ramp, hold, fault };
#pragma symreal function input(u[0:4]) range(-2, 12) output(return)
double machine(double const *u) {
  State state = State::idle;
  double level = 0;
  for (int k = 0; k < 4; ++k) switch (state) {
      case State::idle:
        if (u[k] > 1) state = State::ramp;
        break;
      case State::ramp:
        level += u[k];
        if (level > 10) state = State::fault;
        else if (u[k] < 0.5) state = State::hold;
        break;
      case State::hold:
        if (u[k] < 0) return level;
        break;
      case State::fault: level = -1; break;
    }
  return level;
}

int main() {
  double x[5] = {3, 1, 4, 1.5, 9}, y[5];
  sort5(x, y);
  double A[3][3] = {{4, 3, 2}, {1, 5, 7}, {2, 8, 1}}, b[3] = {1, 2, 3}, z[3];
  solve(A, b, z);
  double p[2] = {0.3, 0.7}, u[4] = {2, 3, 0.25, 1};
  std::printf("%g %g %g %g\n", y[0], z[0], descend(p), machine(u));
}
