#include <cstdarg>
#include <cstdio>
static double total(int n, ...) {
  va_list list;
  va_start(list, n);
  double sum = 0.0;
  for (int i = 0; i < n; i++) sum += va_arg(list, double);
  va_end(list);
  return sum;
}
#pragma symreal function input(x) output(return)
double kernel(double x) { return total(2, x, 1.0); }
int main() { std::printf("%g\n", kernel(5.3)); }
