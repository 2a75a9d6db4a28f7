#include <cstdint>
#include <cstdio>
#include <cstring>
#pragma symreal function input(x) output(return)
double kernel(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return x + static_cast<double>(bits >> 52);
}
int main() { std::printf("%g\n", kernel(5.3)); }
