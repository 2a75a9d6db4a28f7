#include <array>
#include <cmath>
#include <cstdio>

#define value 7
#define state(i) gain[i]
#define fit 0.5

namespace {
double const gain[N] = {1, 2, 3, 4, 5, 6};
template <class Number> Number square(Number number) { return number * number; }
} // namespace

#pragma symreal function input(x) range(-2, 2) output(y) decisions(select)
void mix(std::array<double, N> const &x, std::array<double, T> &y) {
  for (int i = 0; i < T; ++i) {
    y[i] = std::sin(x[i]) * state(i) + value * square(x[N - 1]);
    if (y[i] > T) y[i] = fit;
  }
}

int main() {
  std::array<double, N> x = {0.5, 1, 1.5, 2, -1, -0.5};
  std::array<double, T> y;
  mix(x, y);
  std::printf("%.9g\n", y[0]);
}
