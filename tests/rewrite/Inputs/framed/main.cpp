#include <cassert>
#include <frame.h>

#define PASTED(x) x##0

static double level = 1;

#pragma symreal function input(x) output(return) constant(level)
double twice(double x) { return 2 * x + level; }

int main() {
  double half = 0.5;
  assert(half > 0.25);
  assert((double)half > level - 1 && "text, (");
  // clang-format off
  if (SAME(half, 0.5) && SAME(2.0 * half,
      1.0)) std::puts("yes");
  // clang-format on
  double z = PASTED(1.);
  if (NEAR(z, 1.0)) std::printf("%g\n", twice(half));
}
