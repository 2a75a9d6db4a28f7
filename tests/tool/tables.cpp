// Arrays of constants that are read at an index that depends on an input: indexed loads, in every way to decide.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s --decisions=select -o %t/select.c
// RUN: FileCheck %s --input-file=%t/select.c
// CHECK: static double const table_0[6] = {
// CHECK: compute(
// CHECK: table_{{[0-9]}}[table_index({{.*}}, 3)*4 + table_index({{.*}}, 4)]
// RUN: %symreal verify %s %t/select.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: 1000 samples{{.*}}, 1{{[0-9]+}} within the premises
// SAME: value_return {{ *}}1 {{ *}}0 {{ *}}0{{$}}
// Under guards an index that was clamped needs none; elsewhere the index stays within its table.
// RUN: %symreal generate %s --decisions=guard -o %t/guard.c 2>&1 | FileCheck %s --check-prefix=GUARD
// GUARD: guard 1 tables.cpp:[[#@LINE+21]]:3: i < 0 (trunc(x) < 0) is false
// GUARD: guard 2 tables.cpp:[[#@LINE+21]]:3: i > 4 (trunc(x) > 4) is false
// GUARD-NOT: {{tables.cpp:(3[6-9]|4)}}
// RUN: %symreal verify %s %t/guard.c 2>&1 | FileCheck %s --check-prefix=BOTH
// BOTH: refused by a guard: {{[1-9]}}
// BOTH: value_return {{ *}}1 {{ *}}0 {{ *}}0{{$}}
// A lookup decides nothing, the comparisons of an index do.
// RUN: not %symreal generate %s -o %t/error.c 2>&1 | FileCheck %s --check-prefix=ERROR --implicit-check-not="decides on"
// ERROR-DAG: tables.cpp:[[#@LINE+13]]:3: error: the program decides on a symbolic value: i < 0
// ERROR-DAG: tables.cpp:[[#@LINE+13]]:3: error: the program decides on a symbolic value: i > 4
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

static double const curve[6] = {0.0, 1.5, 2.0, 1.0, -0.5, 3.0};
static double const map[3][4] = {{1, 2, 3, 4}, {2, 4, 6, 8}, {1, 0, 1, 0}};
static std::array<double, 4> const knots = {1.0, 2.5, 3.0, 7.0};

double linear(double x) {
  int i = (int)x;
  if (i < 0) i = 0;
  if (i > 4) i = 4;
  return curve[i] + (x - i) * (curve[i + 1] - curve[i]);
}
double bilinear(double x, double y) {
  int const i = std::clamp(static_cast<int>(std::floor(x)), 0, 1), j = std::clamp((int)y, 0, 2);
  double const u = x - i, w = y - j;
  return (1 - u) * ((1 - w) * map[i][j] + w * map[i][j + 1]) + u * ((1 - w) * map[i + 1][j] + w * map[i + 1][j + 1]);
}
double pointed(double const *t, int n, double x) {
#pragma symreal table(t[0:n])
  int k = std::min(std::max(int(x), 0), n - 1);
  return t[k] * x;
}
#pragma symreal function input(x, y) output(return)
double f(double x, double y) {
  return linear(x) + bilinear(x, y) + knots[std::lround(std::fabs(y)) % 4] + pointed(curve, 6, y);
}
int main() { std::printf("%.17g\n", f(1.3, 0.7)); }
