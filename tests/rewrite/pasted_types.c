// A macro that stands for the type, and whose spelling another macro pastes: the type is converted, and what is made of
// the spelling stays what it was.
// RUN: %same %s
// RUN: %rewrite %s | FileCheck %s
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=100
#include <float.h>
#include <stdio.h>
#include <string.h>

// CHECK: #define number REAL
#define number double
#define double_EPSILON DBL_EPSILON
#define double_name "of double"
#define PASTE_(type, what) type##_##what
#define PASTE(type, what) PASTE_(type, what)
#define TEXT_(type) #type
#define TEXT(type) TEXT_(type)
#define epsilon PASTE(number, EPSILON)

#pragma symreal function input(x) output(return)
number kernel(number x) {
  // CHECK: x + REAL_PASTED((2.2204460492503131e-16), epsilon) *
  return x + epsilon * PASTE(number, EPSILON);
}

int main(void) {
  // CHECK: strcmp(REAL_PASTED(("of double"), PASTE(number, name)), "of double")
  // CHECK: strcmp(REAL_PASTED(("double"), TEXT(number)), "double")
  if (strcmp(PASTE(number, name), "of double") != 0 || strcmp(TEXT(number), "double") != 0) return 1;
  printf("%g\n", kernel(1));
  return 0;
}
