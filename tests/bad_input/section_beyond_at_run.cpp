// A section beyond a container, or of a length that only the run knows, is an error where the program reaches the annotation; no
// advice to write there.
// RUN: not %symreal generate %s --kernel vector -o %t.c --run-args=1 -- -std=c++20 2>&1 | FileCheck %s --check-prefix=VECTOR --implicit-check-not='SYM053'
// RUN: not %symreal generate %s --kernel local -o %t.c --run-args=2 -- -std=c++20 2>&1 | FileCheck %s --check-prefix=LOCAL
// RUN: not %symreal generate %s --kernel rows -o %t.c --run-args=3 -- -std=c++20 2>&1 | FileCheck %s --check-prefix=ROWS
// RUN: not %symreal generate %s --kernel others -o %t.c --run-args=4 -- -std=c++20 2>&1 | FileCheck %s --check-prefix=OTHERS
// RUN: not %symreal generate %s --kernel instance -o %t.c --run-args=5 -- -std=c++20 2>&1 | FileCheck %s --check-prefix=INSTANCE
// RUN: not ls %t.c
#include <cstdlib>
#include <deque>
#include <span>
#include <valarray>
#include <vector>

// VECTOR: section_beyond_at_run.cpp:[[@LINE+1]]:32: error: 'v[0:5]' reaches beyond 'v', which has 3 elements [SYM203]
#pragma symreal function input(v[0:5]) output(w[0:3])
void vector(std::vector<double> const &v, std::vector<double> &w) {
  for (int i = 0; i < 3; i++) w[i] = v[i] * v[i];
}
// LOCAL: section_beyond_at_run.cpp:[[@LINE+1]]:32: error: 'h[0:n]' reaches beyond 'h', which has 4 elements [SYM203]
#pragma symreal function input(h[0:n]) output(return)
double local(double const h[4], int n) { return h[0] * n; }
// ROWS: section_beyond_at_run.cpp:[[@LINE+1]]:32: error: 'm[0:2][0:3]' reaches beyond the rows 'm[0:2]', which have 2 elements each [SYM203]
#pragma symreal function input(m[0:2][0:3]) output(return)
double rows(std::vector<std::vector<double>> const &m) { return m[0][0] * m[1][1]; }
// OTHERS: section_beyond_at_run.cpp:[[@LINE+1]]:95: error: 's[0:n+1]' reaches beyond 's', which has 2 elements [SYM203]
#pragma symreal function constant(n) parameter(q[0:n]) input(a[n-1:1]) scratch(c[0:n]) output(s[0:n+1])
void others(std::deque<double> const &q, std::valarray<double> const &a, std::vector<double> c, std::span<double> s, int n) {
  for (int i = 0; i < n; ++i) s[i] = q[i] * a[n - 1];
}
// INSTANCE: section_beyond_at_run.cpp:[[@LINE+2]]:32: error: 'x[0:3]' reaches beyond 'x', which has 2 elements [SYM203]
template <int n>
#pragma symreal function input(x[0:3]) output(return)
double instance(double (&x)[n]) { return x[0] * x[1]; }

int main(int, char **arguments) {
  std::vector<double> v(3, 0.5), w(3);
  double out[2], x[2] = {1, 2};
  switch (std::atoi(arguments[1])) {
  case 1: vector(v, w); break;
  case 2: local(v.data(), std::atoi("5")); break;
  case 3: rows({{1, 2}, {3, 4}}); break;
  case 4: others({1, 2}, {3, 4}, v, out, 2); break;
  default: instance<2>(x);
  }
}
