// The program's next call of a kernel is compared as well if another kernel, whose calls before it are not recorded, takes text.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: cd %t && %symreal generate %s -o ./ -- -std=c++17
// RUN: cd %t && not %symreal verify %s reference.c plain.c --samples=20 --min-samples=5 -- -std=c++17 2>&1 | FileCheck %s
// CHECK: kernel reference,
// CHECK: error: in the program's next call the original gives other outputs on 4 samples: it reads something that the recording has baked in, and that the program changes [SYM091]
// CHECK: kernel plain,
// CHECK-NOT: error:
#include <cstdio>
#include <functional>
#include <string>

struct Law {
  virtual double of(double x) const { return x; }
};
struct Twice : Law {
  double of(double x) const override { return 2 * x; }
};
static Law once;
static Twice twice;
static std::reference_wrapper<Law> law = once;
#pragma symreal function input(x) output(return)
static double reference(double x) { return law.get().of(x) + 1; }

#pragma symreal function input(x) output(return)
static double plain(double x, std::string const &unit) { return unit == "m" ? x : 1000 * x; }

static double both() {
  double const first = reference(0.5);
  return first + plain(0.5, "m");
}

int main() {
  double const first = both();
  law = twice;
  std::printf("%g %g\n", first, both());
}
