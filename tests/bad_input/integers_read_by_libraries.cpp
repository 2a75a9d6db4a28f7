// Integers of the caller that functions of the library read, by references, ranges and bytes, count as read.
// RUN: not %symreal generate %s -o %t/ 2>&1 | FileCheck %s
// RUN: %symreal generate %s -o %t/ -- -DNAMED 2>&1 | FileCheck %s --check-prefix=NAMED --implicit-check-not=error:
// RUN: not %symreal generate %s -o %t/ -- -DNAMED -DCLEARED 2>&1 | FileCheck %s --check-prefix=CLEARED
// NAMED-COUNT-6: wrote {{.*}}.c
#include <algorithm>
#include <cstring>
#include <numeric>
#include <vector>

struct Settings {
  int count;
  short kind;
};
// CHECK-DAG: [[@LINE+6]]:{{[0-9]+}}: error: kernel 'by_reference' reads 's->count' (3), which is neither input nor parameter [SYM017]
#ifdef NAMED
#pragma symreal function input(x) constant(*s) output(return)
#else
#pragma symreal function input(x) output(return)
#endif
double by_reference(double x, Settings const *s) { return x * std::max(s->count, 1); }

// CHECK-DAG: error: kernel 'copied' reads 'w' (5, 3, 4), which are neither input nor parameter [SYM017]
#ifdef NAMED
#pragma symreal function input(x) constant(w[0:3]) output(return)
#else
#pragma symreal function input(x) output(return)
#endif
double copied(double x, int const *w) {
  int v[3];
  std::memcpy(v, w, sizeof v);
  return x * v[1];
}

// CHECK-DAG: error: kernel 'copied_structure' reads 's' (3, 4), which are neither input nor parameter [SYM017]
#ifdef NAMED
#pragma symreal function input(x) constant(*s) output(return)
#else
#pragma symreal function input(x) output(return)
#endif
double copied_structure(double x, Settings const *s) {
  Settings own;
  std::memcpy(&own, s, sizeof own);
  return x * own.count;
}

// CHECK-DAG: error: kernel 'range' reads 'w' (5, 3, 4), which are neither input nor parameter [SYM017]
#ifdef NAMED
#pragma symreal function input(x) constant(w[0:3]) output(return)
#else
#pragma symreal function input(x) output(return)
#endif
double range(double x, int const *w) { return x * std::accumulate(w, w + 3, 0); }

// CHECK-DAG: error: kernel 'constructed' reads 'w' (5, 3, 4), which are neither input nor parameter [SYM017]
#ifdef NAMED
#pragma symreal function input(x) constant(w[0:3]) output(return)
#else
#pragma symreal function input(x) output(return)
#endif
double constructed(double x, int const *w) { return x * std::vector<int>(w, w + 3)[1]; }

// Nothing of it is read; and what was zero before would not be the next time.
// CLEARED: error: the kernel writes 'w', which is not an output [SYM053]
#ifdef CLEARED
#pragma symreal function input(x) output(return)
#else
#pragma symreal function input(x) scratch(w[0:3]) output(return)
#endif
double cleared(double x, int *w) {
  std::memset(w, 0, 3 * sizeof *w);
  return x * (w[1] + 2);
}

int main() {
  int w[3] = {5, 3, 4}, zeros[3] = {};
  Settings s{3, 4};
  double y = by_reference(0.5, &s) + copied(0.5, w) + copied_structure(0.5, &s) + range(0.5, w) + constructed(0.5, w);
  y += cleared(0.5, zeros);
  w[1] = s.count = s.kind = y > 1;
}
