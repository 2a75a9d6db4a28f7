/* Names that are keywords of C++, in C: each has another name in symbolic mode, wherever it stands. */
// RUN: %rewrite %s > %t.out && FileCheck %s < %t.out
// RUN: %same %s
// RUN: rm -rf %t && mkdir %t && cp %s %t/k.c && cd %t && %symreal generate k.c -o new.c 2> log && %symreal verify --samples=100 --min-samples=10 k.c new.c 2>&1 | FileCheck %s --check-prefix=VERIFIED
// RUN: FileCheck %s --check-prefix=CODE < %t/new.c
// RUN: cd %t && %symreal rewrite k.c --out-root once && cd once && %symreal rewrite k.c --diff 2> log | count 0
#include <stdio.h>

// CHECK: typedef enum { REAL_NAME(false), REAL_NAME(true) } REAL_NAME(bool);
typedef enum { false, true } bool;
// CHECK: struct REAL_NAME(class) { REAL_MEMBERS(public, REAL_NAME(this), REAL_NAME(new)) REAL REAL_NAME(this), REAL_NAME(new)[2]; };
struct class { double this, new[2]; };
// CHECK: #define NEW(x) (REAL_READ("(x)->new[0]", {{.*}}, (x)->REAL_NAME(new)[0]))
#define NEW(x) ((x)->new[0])
#define SAME(x) x

static double gain;
static bool export = true;

#pragma symreal function input(template->this, template->new) input(delete) range(0, 1) parameter(gain) output(return)
// CHECK: static REAL REAL_NAME(typename)(struct REAL_NAME(class) *REAL_NAME(template), REAL REAL_NAME(delete))
// CHECK-NEXT: SYMREAL_OBJECT(input, "template->this", {{[^)]*}}, REAL_NAME(template)->REAL_NAME(this))
static double typename(struct class *template, double delete)
{
  double try = template->this * delete;
  if (export == false) goto catch;
  try = NEW(template) + SAME(try) + gain;
catch:
  return try;
}

int main(void)
{
  struct class one = {.this = 0.5, .new = {1.5, 2.5}};
  printf("%g\n", typename(&one, 3));
  return 0;
}
// CODE: "kernel":"typename"
// CODE: double const try_ = constants[0] + (input[1] + input[0]*input[3]);
// VERIFIED: 100 within the premises
// VERIFIED: value_return 1 0 0
