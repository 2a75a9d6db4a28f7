// Integers that are made of REALs keep their dependency as long as they are computed with, and so do elements that are
// read at such an index; elsewhere they are plain integers again.
// RUN: %rewrite %s | sed -E -e 's/"[^"]*tables.cpp:[0-9:]*"/P/g' | FileCheck %s
// RUN: %same %s
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>
static double const curve[6] = {0.0, 1.5, 2.0, 1.0, -0.5, 3.0};
static double const map[3][4] = {{1, 2, 3, 4}, {2, 4, 6, 8}, {1, 0, 1, 0}};
static std::array<double, 4> const knots = {1.0, 2.5, 3.0, 7.0};
void plain(int);

// CHECK-LABEL: REAL linear(REAL x)
double linear(double x) {
  // CHECK: REAL_INT(int) i = (REAL_INT(int))x;
  int i = (int)x;
  // CHECK: REAL_IF((i), i < 0) i = 0;
  if (i < 0) i = 0;
  // CHECK: i = std::min(i, 4);
  i = std::min(i, 4);
  // CHECK: return REAL_TABLE("curve", P, curve)[i] + (x - i) * (REAL_TABLE("curve", P, curve)[i + 1] - REAL_TABLE("curve", P, curve)[i]);
  return curve[i] + (x - i) * (curve[i + 1] - curve[i]);
}
// CHECK-LABEL: REAL bilinear
double bilinear(double x, double y) {
  // CHECK: REAL_INT(int) const i = static_cast<REAL_INT(int)>(std::floor(x)), j = std::clamp(REAL_INT(int)(y), 0, 2);
  int const i = static_cast<int>(std::floor(x)), j = std::clamp(int(y), 0, 2);
  // CHECK: return REAL_TABLE("map", P, map)[i][j] + REAL_TABLE("map", P, map)[1][j] + REAL_TABLE("map", P, map)[i][0];
  return map[i][j] + map[1][j] + map[i][0];
}
// CHECK-LABEL: REAL pointed
double pointed(double const *t, unsigned n, double x, std::vector<double> const &v) {
  // CHECK: SYMREAL_TABLE(t, n)
#pragma symreal table(t[0:n])
  // CHECK: auto k = std::lround(x);
  auto k = std::lround(x);
  unsigned m = 3;
  // CHECK: return REAL_TABLE("t", P, t)[k] + REAL_TABLE("knots", P, knots)[k % 4] + REAL_TABLE("v", P, REAL_READ("v", P, v))[-k] + REAL_READ("t[m]", P, t[m]);
  return t[k] + knots[k % 4] + v[-k] + t[m];
}
// Places for plain integers: arguments, other arrays, switches, shared declarations with a pointer.
// CHECK-LABEL: int elsewhere
int elsewhere(double x) {
  // CHECK: int i = REAL_TO(int, x), *p = &i;
  int i = x, *p = &i;
  // CHECK: REAL_INT(int) k = REAL_TO(REAL_INT(int), x);
  int k = x;
  // CHECK: plain(REAL_TO(int, k));
  plain(k);
  // CHECK: std::printf("%d", REAL_VALUE(k));
  std::printf("%d", k);
  // CHECK: bool flags[3] = {};
  bool flags[3] = {};
  // CHECK: flags[k] = REAL_READ({{.*}}, *p) > 1;
  flags[k] = *p > 1;
  // CHECK: for (int j = 0; j < REAL_TO(int, k) && j < (int)x; ++j) plain(j);
  for (int j = 0; j < k && j < (int)x; ++j) plain(j);
  // CHECK: switch (k)
  switch (k) {
  case 1: return k;
  }
  // CHECK: return k;
  return k;
}
