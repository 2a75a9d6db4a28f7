// What lies beyond the bounds is left out with a warning: guards refuse inputs that lead there, and verification shows that
// they do, and that the rest is right. A loop whose number of rounds depends on its inputs ends at the bound of depth.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/ --decisions=explore --explore=joins=off --explore=paths=6 --explore=depth=5 --json 2> %t/table > %t/json
// RUN: FileCheck %s < %t/table
// CHECK: bounds.cpp:[[#@LINE+37]]:32: warning: of kernel 'rounds' 5 paths are recorded, and 1 guard refuses what remains [SYM192]
// CHECK: note: 1 path cut off beyond 5 decisions (--explore=depth)
// CHECK: bounds.cpp:[[#@LINE+42]]:32: warning: of kernel 'wide' 6 paths are recorded, and {{[0-9]+}} guards refuse what remains [SYM192]
// CHECK: note: there are more than 6 paths (--explore=paths)
// CHECK: help: raise the limit (--explore=paths=N,depth=N), bound loops with a pragma (loop(N)), or accept the guards
// CHECK: kernel rounds:
// CHECK: explored 5 paths, 4 selects between them; not complete: see the guards
// CHECK: 1 cut off by the depth, 0 ended by the program, 0 not in time
// CHECK: guard 1 bounds.cpp
// CHECK: kernel wide:
// CHECK: explored 6 paths, {{[0-9]+}} selects between them; not complete: see the guards
// RUN: FileCheck %s --check-prefix=JSON < %t/json
// JSON: "cut_off": 1,
// JSON: "more_paths": false,
// JSON-NEXT: "complete": false
// JSON: "more_paths": true,
// RUN: %symreal verify --samples=100 --min-samples=10 %s rounds.c wide.c > %t/verified 2>&1
// RUN: FileCheck %s --check-prefix=SIDES < %t/verified
// SIDES: kernel rounds, mode finite
// SIDES: refused by a guard: {{[1-9]}}
// SIDES: value_return 1 0 0{{$}}
// SIDES: kernel wide, mode finite
// SIDES: refused by a guard: {{[1-9]}}
// SIDES-NOT: no sample failed
// SIDES: value_return 1 0 0{{$}}
// A larger bound leaves nothing out.
// RUN: %symreal generate %s -o %t/all.c --kernel wide --decisions=explore --explore=joins=off --explore=paths=16 2>&1 | FileCheck %s --check-prefix=ALL
// ALL-NOT: warning
// ALL: explored 16 paths, 14 selects between them; complete: no guards
// The bounds may stand in a configuration. Without the policy they have no effect.
// RUN: printf 'options: {decisions: explore, explore: "paths=6,depth=5,joins=off"}\n' > %t/c.yaml
// RUN: %symreal generate %s -o %t/configured.c --kernel wide --config c.yaml && tail -n +7 %t/wide.c > %t/wide
// RUN: tail -n +7 %t/configured.c | sed s/configured/wide/ | diff - %t/wide
// RUN: not %symreal generate %s -o %t/none.c --explore=paths=6 2>&1 | FileCheck %s --check-prefix=NONE
// NONE: error: --explore has no effect without --decisions=explore or auto [SYM010]
#include <cstdio>

#pragma symreal function input(x) range(0, 100) output(return)
double rounds(double x) {
  double sum = 0;
  for (; x > 1; x /= 2) sum += x;
  return sum;
}

#pragma symreal function input(x[0:4]) output(return)
double wide(double const *x) {
  double sum = 0;
  int k = 0;
  for (int i = 0; i < 4; ++i) k += x[i] > 0 ? i + 1 : 0;
  for (int i = 0; i < k; ++i) sum += x[i % 4];
  return sum;
}

int main() {
  double x[4] = {1, -1, 2, 3};
  std::printf("%g %g\n", rounds(3), wide(x));
}
