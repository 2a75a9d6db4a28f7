// N samples of a filter of second order in two sections.
#include <cstdlib>
#include <vector>

#pragma symreal function input(x[0 : n]) constant(n) output(y[0 : n])
void filter(double const *x, int n, double *y) {
  double state[2][2] = {};
  for (int k = 0; k < n; k++) {
    double value = x[k];
    for (double(&s)[2] : state) {
      double const next = value - 0.5 * s[0] + 0.25 * s[1];
      value = 0.3 * next + 0.6 * s[0] + 0.3 * s[1];
      s[1] = s[0];
      s[0] = next;
    }
    y[k] = value;
  }
}

#ifndef NO_MAIN
int main(int, char **argv) {
  int const n = std::atoi(argv[1]);
  std::vector<double> x(n, 0.5), y(n);
  filter(x.data(), n, y.data());
}
#endif
