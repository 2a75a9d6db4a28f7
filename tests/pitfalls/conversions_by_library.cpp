// What the library converts by itself where it is given numbers: elements that it reads, writes and sums up.
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c --decisions=guard && %symreal verify --samples=100 %s %t.c --min-samples=1
// RUN: env SYMREAL_ROOTS=%S %symreal-c++ -DPLAIN %s -o %t.exe && %t.exe | FileCheck %s --check-prefix=PRINTED
// PRINTED: 11 10 40 3.5 9 4 3.5 6
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

static double sum(double a, double b) { return a + b; }

int main() {
  double x[4] = {1.5, 2.5, 3.5, 4.5};
  std::vector<double> const d(x, x + 4);
  std::vector<float> v;
  // CHECK: v.assign({{.*}}REAL_ONLY(::symreal::SymrealReading<float>() ->*) x{{.*}}, {{.*}}REAL_ONLY(::symreal::SymrealReading<float>() ->*) x + 2
  v.assign(x, x + 2);
  v.insert(v.end(), d.begin(), d.end());
  // CHECK: REAL_TO(::symreal::SymrealTotal<int>, 1), sum);
  int const s = std::accumulate(x, x + 4, 1, sum);
  int const t = std::accumulate(d.begin(), d.end(), 0);
  long const u = std::inner_product(x, x + 4, x, 0L);
  float f[4];
  int n[4];
  // CHECK: REAL_ONLY(::symreal::SymrealWriting() ->*) f);
  std::copy(x, x + 4, f);
  int *const end = std::transform(x, x + 4, n, [](double q) { return std::floor(2 * q); });
  std::printf("%d %d %ld %g %d %d %g %d\n", s, t, u, static_cast<double>(f[2]), n[3], static_cast<int>(end - n),
              static_cast<double>(v[4]), static_cast<int>(v.size()));
#ifndef PLAIN
  double y;
#pragma symreal input(x) range(1, 1.0001)
  y = std::accumulate(x, x + 4, 0) * x[0];
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
#endif
}
