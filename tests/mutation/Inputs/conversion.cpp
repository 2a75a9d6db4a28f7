#include <cstdio>
static double turned(int turns, double x) { return turns * x; }
#pragma symreal function input(x) range(5.1, 5.9) output(return) decisions(guard)
double kernel(double x) { return turned(x, x); }
int main() { std::printf("%g\n", kernel(5.3)); }
