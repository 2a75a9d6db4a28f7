#include <cstdio>

static double const low[2] = {1, 2}, high[2] = {3, 4};

struct Holder {
  double const (&table)[2];
};
static Holder const *holder = new Holder{low};

#pragma symreal function input(x) output(return)
double scaled(double x) { return holder->table[1] * x; }

int main() {
  std::printf("%g", scaled(0.5));
  holder = new Holder{high};
  std::printf(" %g\n", scaled(0.5));
}
