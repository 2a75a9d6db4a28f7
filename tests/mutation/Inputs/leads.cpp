#include <cstdio>

static double const low[2] = {1, 2}, high[2] = {3, 4};

struct Table {
  double const *numbers;
};
static Table table = {low};

#pragma symreal function input(x) output(return)
double scaled(double x) {
  Table const mine = table;
  return mine.numbers[1] * x;
}

int main() {
  std::printf("%g", scaled(0.5));
  table.numbers = high;
  std::printf(" %g\n", scaled(0.5));
}
