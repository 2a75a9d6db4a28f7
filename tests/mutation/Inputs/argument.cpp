#include <cstdio>
struct Value {
  double v;
  Value(double x) : v(x) {}
};
static double f(int i) { return 10.0 * i; }
static double f(Value const &value) { return value.v; }
template <class T> double g(T x) { return f(x); }
#pragma symreal function input(x) range(5.1, 5.9) output(return) decisions(guard)
double kernel(double x) { return g(x) * x; }
int main() { std::printf("%g\n", kernel(5.3)); }
