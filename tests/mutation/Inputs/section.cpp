#include <cstdio>
#pragma symreal function input(a[0 : 4]) output(return)
double kernel(double (&a)[3]) { return a[0] * a[2]; }
int main() {
  double a[3] = {1, 2, 3};
  std::printf("%g\n", kernel(a));
}
