#include <cstdio>
#define SHOWN(e) (std::puts(#e), (e))
#pragma symreal function input(x) output(return)
double kernel(double x) { return x * SHOWN(double(3)); }
int main() { std::printf("%g\n", kernel(5.3)); }
