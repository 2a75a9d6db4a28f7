#include <cstdint>
#include <cstdio>
union Bits {
  double number;
  std::uint64_t bits;
};
#pragma symreal function input(x) output(return)
double kernel(double x) {
  Bits u;
  u.number = x;
  return x + static_cast<double>(u.bits >> 52);
}
int main() { std::printf("%g\n", kernel(5.3)); }
