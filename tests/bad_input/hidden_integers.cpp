// Integers that the program could change and that a kernel reads are baked in like numbers. They may share a word.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c
// RUN: %symreal generate %s -o %t.c --frozen=allow 2>&1 | FileCheck %s --check-prefix=LISTED --implicit-check-not=SYM017
// RUN: %symreal verify %s %t.c --samples=100

#include <cstdio>
#include <vector>

enum class Law { linear, square };

static Law law = Law::square;
bool swapped = false, doubled = true;
static int const fixed = 3;
static int never_changed = 4; // and nobody else sees it
static short order[2] = {1, 0};

void configure(Law chosen, short first) { law = chosen, order[0] = first; }

struct Options {
  int degree;
  signed char sign;
  bool verbose;
};

class Series {
public:
  Series(int terms, std::vector<int> powers, Options options) : terms_(terms), powers_(powers), options_(options) {}
  double sum(double x) const {
    double total = 0;
    for (int i = 0; i < terms_; i++) total += x;
    for (int power : powers_) total *= power;
    Options const copy = options_;
    return copy.sign * total;
  }

private:
  int terms_;
  std::vector<int> powers_;
  Options options_;
};

#pragma symreal function input(x[0:n]) output(return)
double series(Series const &series, double const *x, int n, int degree, int unused, unsigned const *shift) {
  double y = series.sum(x[order[0]]);
  switch (law) {
  case Law::linear: break;
  case Law::square: y *= y; break;
  }
  for (int i = 0; i < degree; ++i) y += x[0] + *shift;
  return (doubled ? 2 * y : y) + fixed + never_changed;
}

int main() {
  double const x[2] = {0.5, 0.25};
  unsigned const shift = 4000000000;
  std::printf("%g\n", series(Series(2, {2, 3}, {5, -1, true}), x, 2, 3, 4, &shift));
  if (swapped) configure(Law::linear, 1);
}

// CHECK: hidden_integers.cpp:13:12: error: kernel 'series' reads 'law' (1), which is neither input nor parameter [SYM017]
// CHECK: hidden_integers.cpp:14:23: error: kernel 'series' reads 'doubled' (1), which is
// CHECK: hidden_integers.cpp:17:14: error: kernel 'series' reads 'order' (1), which is
// CHECK: hidden_integers.cpp:32:25: error: kernel 'series' reads 'terms_' (2), which is
// CHECK: note: called from series(
// CHECK: hidden_integers.cpp:33:22: error: kernel 'series' reads 'powers_' (2, 3), which are
// CHECK: hidden_integers.cpp:34:26: error: kernel 'series' reads 'options_' (5, -1, 1), which are
// CHECK: hidden_integers.cpp:45:65: error: kernel 'series' reads 'degree' (3), which is
// CHECK: hidden_integers.cpp:51:{{[0-9]+}}: error: kernel 'series' reads '*shift' (4e+09), which is neither input nor parameter [SYM017]
// CHECK-NOT: SYM017]
// LISTED: baked in        law = 1  (
