#include <cstdio>
#include <model/spring.h>

#pragma symreal function input(x) parameter(k) output(return)
double energy(double k, double x) { return spring(k, x) * x * 0.25; }

int main() { std::printf("%g\n", energy(3, 0.5)); }
