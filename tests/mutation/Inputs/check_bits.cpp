#include <cstdio>
#include <cstring>
// The address is an integer on its way: the source does not show that numbers lie there.
static void clear(unsigned long address) {
  void *(*volatile fill)(void *, int, std::size_t) = std::memset;
  fill(reinterpret_cast<void *>(address), 0, 4);
}
#pragma symreal function input(x) output(return)
double kernel(double x) {
  struct {
    double value;
  } cell = {x * 3.0};
  clear(reinterpret_cast<unsigned long>(&cell));
  return 2.0 * cell.value;
}
int main() { std::printf("%.17g\n", kernel(0.7)); }
