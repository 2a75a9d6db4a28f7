#include <cstdio>
#include <vector>
#pragma symreal function input(v[0 : 5]) output(return)
double kernel(std::vector<double> const &v) { return v[0] * v[2]; }
int main() { std::printf("%g\n", kernel({1, 2, 3})); }
