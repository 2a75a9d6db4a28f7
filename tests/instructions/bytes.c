// C that moves numbers as bytes: rewriting refuses it, its instructions are recorded.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: not %symreal generate %s -o rewritten.c > refused 2>&1
// RUN: FileCheck %s --check-prefix=REFUSED < refused
// REFUSED: error: {{.*}} [SYM035]
// RUN: %symreal generate %s -o code.c --record=instructions --graph code.graph > table 2>&1
// RUN: FileCheck %s < table
// CHECK: symreal: --record=instructions does not see what kernel 'advance' reads of the locals around its block: it is baked in
// CHECK: kernel advance: 4 inputs, 0 parameters, 4 outputs
// RUN: FileCheck %s --check-prefix=C < code.c
// C: "from":"instructions"
// RUN: %symreal opt code.graph --lang=c -o again.c && FileCheck %s --check-prefix=C < again.c
// RUN: %symreal verify %s code.c --samples=100 > verified 2>&1 && FileCheck %s --check-prefix=SAME < verified
// SAME: kernel advance, mode finite: 100 samples
// SAME: state[0]
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef union {
  double all[4];
  struct {
    double x, y, vx, vy;
  };
  uint64_t bits[4];
} class;

static int is_zero(class const *new) {
  uint64_t this = 0;
  for (int k = 0; k < 4; ++k) this |= new->bits[k] << 1;
  return this == 0;
}

static double scaled(x, by)
double x, by;
{ return x * by; }

static void advance(double *state) {
#pragma symreal input(state[0:4]) range(1, 2)
  class *const try = malloc(sizeof *try), copy;
  memcpy(try->all, state, sizeof try->all);
  for (int k = 0; k < 4; ++k) copy.bits[k] = try->bits[k];
  double const r2 = copy.x * copy.x + copy.y * copy.y, a = -1 / (r2 * sqrt(r2));
  try->x += scaled(copy.vx, 0.01);
  try->y += scaled(copy.vy, 0.01);
  try->vx += scaled(a * copy.x, 0.01);
  try->vy += scaled(a * copy.y, 0.01);
  memcpy(state, try, sizeof *try);
  free(try);
#pragma symreal output(state[0:4]) generate("advance.c")
}

int main(void) {
  double state[] = {1, 0.5, 0.1, 1};
  class start = {{0, 0, 0, 0}};
  if (is_zero(&start)) advance(state);
  return state[0] == 0;
}
