#include <cstdint>
#include <cstdio>
#pragma symreal function input(x) output(return)
double kernel(double x) { return x + static_cast<double>(*reinterpret_cast<std::uint64_t *>(&x) >> 52); }
int main() { std::printf("%g\n", kernel(5.3)); }
