#include <cstdio>
#pragma symreal function input(x) output(return)
double kernel(double x) {
  try {
    throw x > 1;
  } catch (bool) {
    return x;
  } catch (...) {
    return -x;
  }
}
int main() { std::printf("%g\n", kernel(5.3)); }
