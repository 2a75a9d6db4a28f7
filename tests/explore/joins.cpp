// Where both ways from a decision come back to one state but for numbers, they are one path, and a select stands for each
// number that differs: n branches cost 2n pieces of a run, whatever their arms do.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/ --decisions=explore --json > %t/json 2> %t/table
// RUN: FileCheck %s < %t/table
// CHECK-NOT: warning
// CHECK: kernel branches:
// CHECK: explored 1 path, 0 selects between them; complete: no guards
// CHECK-NEXT: the ways from 10 decisions came together: 20 pieces of a run, 20 selects
// CHECK: kernel network:
// CHECK: explored 1 path, 0 selects between them; complete: no guards
// CHECK-NEXT: the ways from 15 decisions came together: 30 pieces of a run, 30 selects
// CHECK: kernel sum_limited:
// CHECK: explored 1 path, 0 selects between them; complete: no guards
// CHECK: kernel largest:
// CHECK: explored 1 path, 0 selects between them; complete: no guards
// CHECK: kernel sort5:
// CHECK: complete: no guards
// Attempts that fail are bounded by what the paths take anyhow.
// RUN: python3 -c "import json; all = [k['exploration'] for k in json.load(open('%t/json'))['kernels']]; assert all[4]['in_vain'] > 0 and not any(one['in_vain'] > one['decided'] + 2000 for one in all), all"
// RUN: FileCheck %s --check-prefix=JSON < %t/json
// JSON: "joins": 10,
// JSON: "pieces": 20,
// RUN: %symreal verify %s branches.c network.c sum_limited.c largest.c sort5.c --samples=200 > %t/verified 2>&1
// RUN: FileCheck %s --check-prefix=SAME < %t/verified
// SAME: kernel branches, mode finite: 200 samples and 60 around decisions, 260 within the premises
// SAME-NEXT: every path is recorded: no sample is left to a guard
// SAME-NEXT: decisions: 10 of 10 went both ways
// SAME: y[0] 10 0 0{{$}}
// SAME: kernel network, mode finite
// SAME-NEXT: every path is recorded: no sample is left to a guard
// SAME-NEXT: decisions: 15 of 15 went both ways
// SAME: y[0] 6 0 0{{$}}
// SAME: kernel sum_limited, mode finite
// SAME-NEXT: every path is recorded: no sample is left to a guard
// SAME: value_return 1 0 0{{$}}
// SAME: kernel largest, mode finite
// SAME-NEXT: every path is recorded: no sample is left to a guard
// SAME: value_return 1 0 0{{$}}
// SAME: kernel sort5, mode finite
// SAME-NEXT: every path is recorded: no sample is left to a guard
// SAME: y[0] 5 0 0{{$}}
// Without joins each way is a path.
// RUN: %symreal generate %s -o %t/apart.c --kernel largest --decisions=explore --explore=joins=off 2>&1 | FileCheck %s --check-prefix=APART
// APART: explored 8 paths, {{[0-9]+}} selects between them; complete: no guards
// RUN: not %symreal generate %s -o %t/none.c --explore=joins=off 2>&1 | FileCheck %s --check-prefix=NONE
// NONE: error: --explore has no effect without --decisions=explore or auto [SYM010]
#include <algorithm>
#include <cstdio>
#include <utility>

typedef double (*Function)(double);
static double twice(double x) { return 2 * x; }
static double cube(double x) { return x * x * x - 0.25; }

// Early returns in a helper.
static double limited(double x) {
  if (x > 2) return 2 + 0.1 * x;
  if (x < -2) return -2 + 0.2 * x;
  return x;
}

#pragma symreal function input(x[0:10]) range(-3, 3) output(y[0:10])
void branches(double const *x, double *y) {
  for (int i = 0; i < 10; ++i) y[i] = 0.25 * x[i];
  for (int i = 0; i < 10; ++i) {
    Function f = twice;
    if (y[i] > 0) {
      f = cube;
      y[i] = f(y[i]);
      std::swap(y[i], y[(i + 1) % 10]);
    } else {
      auto g = [&](double z) { y[i] += f(z); };
      g(y[(i + 3) % 10]);
    }
  }
  y[9] += 1;
}

#pragma symreal function input(x[0:6]) output(y[0:6])
void network(double const *x, double *y) {
  for (int i = 0; i < 6; ++i) y[i] = x[i];
  for (int r = 0; r < 6; ++r)
    for (int i = r % 2; i + 1 < 6; i += 2)
      if (y[i] > y[i + 1]) std::swap(y[i], y[i + 1]);
}

#pragma symreal function input(x[0:8]) range(-4, 4) output(return)
double sum_limited(double const *x) {
  double s = 0;
  for (int i = 0; i < 8; ++i) s += limited(x[i] + 0.1 * s);
  return s;
}

// The same numbers, whichever way, are one place: of the pivot's row there are three.
#pragma symreal function input(x[0:4]) output(return)
double largest(double const *x) {
  int best = 0;
  for (int i = 1; i < 4; ++i)
    if (x[i] > x[best]) best = i;
  return x[best] * 2;
}

#pragma symreal function input(x[0:5]) output(y[0:5])
void sort5(double const *x, double *y) {
  for (int i = 0; i < 5; ++i) y[i] = x[i];
  std::sort(y, y + 5);
}

int main() {
  double x[10] = {1, -2, 3, -1, 2, 0.5, 1, -1, 2, 1}, y[10];
  branches(x, y);
  double z[6];
  network(x, z);
  double s[5];
  sort5(x, s);
  std::printf("%g %g %g %g %g\n", y[0], z[0], sum_limited(x), largest(x), s[0]);
}
