#include <cstdio>
struct Pair {
  double a, b;
};
struct Sum {
  Pair const &x, &y;
  operator Pair() const { return {x.a + y.a, x.b + y.b}; }
};
static Sum operator+(Pair const &x, Pair const &y) { return Sum{x, y}; }
#pragma symreal function input(q) output(return)
Pair kernel(Pair const &q) { return q + q; }
int main() { std::printf("%g\n", kernel({1.5, 2.5}).b); }
