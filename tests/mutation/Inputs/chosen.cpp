#include <cstdio>

static double const low[2] = {1, 2}, high[2] = {3, 4};

#pragma symreal function input(x) output(return)
double scaled(double const *table, double x) { return table[1] * x; }

int main() { std::printf("%g %g\n", scaled(low, 0.5), scaled(high, 0.5)); }
