#include <algorithm>
#include <cstdio>

static int counts[2];

#pragma symreal function input(x) output(return)
double scaled(double x) {
  std::fill(counts, counts + 2, 0);
  return 2 * x;
}

int main() {
  std::printf("%g\n", scaled(0.5));
  counts[1] = 3;
  std::printf("%g %d\n", scaled(0.5), counts[1]);
}
