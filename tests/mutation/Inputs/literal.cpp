#include <cstdio>
static double pick(long) { return 100.0; }
static double pick(double x) { return x; }
#pragma symreal function input(x) output(return)
double kernel(double x) { return x * pick(2.5); }
int main() { std::printf("%g\n", kernel(5.3)); }
