// What an earlier run has compiled is taken as it is, while nothing has changed that it was made from.
// RUN: rm -rf %t && mkdir %t && cp %s %t/model.c && echo '#define GAIN 3' > %t/gain.h
// RUN: env XDG_CACHE_HOME=%t/cache %tool generate %t/model.c -o %t/out.c --stats 2>&1 | FileCheck %s --check-prefix=ONE
// RUN: env XDG_CACHE_HOME=%t/cache %tool generate %t/model.c -o %t/out.c --stats 2>&1 | FileCheck %s --check-prefix=NONE
// RUN: env XDG_CACHE_HOME=%t/cache %tool generate %t/model.c -o %t/out.c --stats --json 2>/dev/null | FileCheck %s --check-prefix=JSON
// RUN: env XDG_CACHE_HOME=%t/cache %tool generate %t/model.c -o %t/out.c --stats --no-cache 2>&1 | FileCheck %s --check-prefix=ONE
// RUN: env XDG_CACHE_HOME=%t/cache %tool cache | FileCheck %s --check-prefix=KEPT1
// verify has the symbolic program, and builds the two others and the generated code.
// RUN: env XDG_CACHE_HOME=%t/cache %tool verify %t/model.c %t/out.c --samples=20 --min-samples=5
// RUN: env XDG_CACHE_HOME=%t/cache %tool cache | FileCheck %s --check-prefix=KEPT3
// RUN: env XDG_CACHE_HOME=%t/cache %tool verify %t/model.c %t/out.c --samples=20 --min-samples=5
// RUN: env XDG_CACHE_HOME=%t/cache %tool cache | FileCheck %s --check-prefix=KEPT3
// Whatever changes counts: a header, flags, a blank, which moves columns, and a header that comes to lie before another.
// RUN: echo '#define GAIN 5' > %t/gain.h
// RUN: env XDG_CACHE_HOME=%t/cache %tool generate %t/model.c -o %t/out.c --stats 2>&1 | FileCheck %s --check-prefix=ONE
// RUN: FileCheck %s --check-prefix=FIVE < %t/out.c
// RUN: env XDG_CACHE_HOME=%t/cache %tool generate %t/model.c -o %t/out.c --stats -- -DOTHER 2>&1 | FileCheck %s --check-prefix=ONE
// RUN: sed -i 's/= GAIN/=  GAIN/' %t/model.c
// RUN: env XDG_CACHE_HOME=%t/cache %tool generate %t/model.c -o %t/out.c --stats 2>&1 | FileCheck %s --check-prefix=ONE
// RUN: mkdir %t/system && mv %t/gain.h %t/system
// RUN: mkdir %t/before && env XDG_CACHE_HOME=%t/cache %tool generate %t/model.c -o %t/out.c -- -I%t/before -I%t/system
// RUN: echo '#define GAIN 7' > %t/before/gain.h
// RUN: env XDG_CACHE_HOME=%t/cache %tool generate %t/model.c -o %t/out.c --stats -- -I%t/before -I%t/system 2>&1 | FileCheck %s --check-prefix=ONE
// RUN: FileCheck %s --check-prefix=SEVEN < %t/out.c
// RUN: env XDG_CACHE_HOME=%t/cache %tool cache --clear | FileCheck %s --check-prefix=CLEARED
// RUN: env XDG_CACHE_HOME=%t/cache %tool cache | FileCheck %s --check-prefix=EMPTY
// A directory that cannot be written is no cache, and no error.
// RUN: env XDG_CACHE_HOME=/proc/none %tool generate %t/model.c -o %t/out.c --stats -- -I%t/before 2>&1 | FileCheck %s --check-prefix=ONE
// ONE: objects: 1 compiled, 0 as an earlier run compiled them
// NONE: objects: 0 compiled, 1 as an earlier run compiled them
// JSON: "objects": {
// JSON-NEXT: "compiled": 0,
// JSON-NEXT: "reused": 1
// KEPT1: {{^}}2 objects and programs, {{[0-9.]+}} MB, in {{.*}}/cache/symreal
// KEPT3: {{^}}8 objects and programs, {{[0-9.]+}} MB, in {{.*}}/cache/symreal
// FIVE: input[0]*5.0
// SEVEN: input[0]*7.0
// CLEARED: removed {{[0-9]+}} objects and programs
// EMPTY: {{^}}0 objects and programs, 0.0 MB
#include "gain.h"
#include <stdio.h>
#pragma symreal function input(x) output(return)
double kernel(double x) {
  double const gain = GAIN;
  return gain * x;
}
int main(void) {
  printf("%g\n", kernel(2.5));
  return 0;
}
