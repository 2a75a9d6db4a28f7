#include <cstdint>
#include <cstdio>
#pragma symreal function input(x) output(return)
double kernel(double x) {
  void const *bytes = &x;
  return x + static_cast<double>(*static_cast<std::uint64_t const *>(bytes) >> 52);
}
int main() { std::printf("%g\n", kernel(5.3)); }
