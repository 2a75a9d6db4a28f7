// The guard x != y is left out, since the last one implies it. Its text is a part of that one's text: the code may return
// any guard after its place that does not hold.
// RUN: %symreal generate %s --decisions=guard -o %t.c 2>&1 | FileCheck %s --check-prefix=SAID
// SAID-NOT: guard {{.*}}: x != y{{$}}
// SAID: guard 2 {{.*}}: (x == 0.25 || y != x) && x != y{{$}}
// RUN: %symreal verify %s %t.c --samples=400 2>&1 | FileCheck %s
// CHECK: different
// CHECK: value_return {{.*}} 0 0
#pragma symreal function input(x, y) range(-4, 4) output(return)
double kernel(double x, double y) {
  double other[2] = {x != y ? x : y, 1};
  if (y > 0.25) other[1] = 2;
  if ((x == 0.25 || y != x) && x != y) return x + y;
  return x * other[1];
}

int main(void) { return kernel(1.5, 2.5) != 4; }
