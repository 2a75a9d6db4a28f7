#include <cmath>
#include <cstdio>
static double apply(double (*f)(double), double x) { return f(x); }
#pragma symreal function input(x) output(return)
double kernel(double x) { return apply(std::sin, x); }
int main() { std::printf("%g\n", kernel(5.3)); }
