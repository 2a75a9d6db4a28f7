// State that would be baked in: an error, a warning, or silent, but always listed.
// RUN: rm -rf %t && mkdir %t
// RUN: not %symreal generate %s -o %t/a.c 2>&1 | FileCheck %s --check-prefixes=ERROR
// ERROR: frozen.cpp:19:{{[0-9]+}}: error: {{.*}}gravity{{.*}}[SYM017]
// RUN: ls -A %t | count 0
// RUN: %symreal generate %s -o %t/a.c --frozen=warn 2>&1 | FileCheck %s --check-prefixes=WARNING,LISTED
// WARNING: frozen.cpp:19:{{[0-9]+}}: warning: {{.*}}gravity{{.*}}[SYM017]
// LISTED: baked in {{.*}}gravity = 9.81
// RUN: FileCheck %s --check-prefix=HEADER < %t/a.h
// HEADER: /* Baked in with the values that the program had there when this was recorded:
// HEADER-NEXT: gravity = 9.81 (frozen.cpp:19:8)
// HEADER-NEXT: */
// RUN: %symreal generate %s -o %t/a.c --frozen=allow 2>&1 | FileCheck %s --check-prefixes=LISTED,ALLOWED
// ALLOWED-NOT: SYM017
// RUN: not %symreal generate %s -o %t/a.c --frozen=maybe 2>&1 | FileCheck %s --check-prefix=VALUE
// VALUE: error: --frozen takes state|error|warn|allow, not 'maybe' [SYM003]
#include <cstdio>

double gravity = 9.81;

int main() {
  double mass = 2, weight;
#pragma symreal input(mass)
  weight = mass * gravity;
#pragma symreal output(weight) generate("weight.c")
  std::printf("%g\n", weight);
}
