#include <cstdio>
struct Spring {
  double stiffness;
  bool is_stiff() const; // the same name in both modes
};
#pragma symreal function input(x) output(return)
double kernel(double x) { return Spring{x}.is_stiff() ? x : 2 * x; }
int main() { std::printf("%g\n", kernel(5.3)); }
