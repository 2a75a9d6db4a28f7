#include <cstdio>
struct Sum {
  double k;
};
#pragma symreal function input(a) constant(sum -> k) output(return)
double kernel(Sum *sum, double a) { return sum->k += a; }
int main() {
  Sum sum{2};
  std::printf("%g\n", kernel(&sum, 0.7));
}
