// Enumerators beside numbers in a template, where no conversion can be written: in a pack, and as arguments that are deduced.
// RUN: %symreal generate %s -o %t.c --decisions=guard && %symreal verify %s %t.c --samples=50
// RUN: %same %s
#include <cstdio>

enum Mode { off = -1, on = 5 };
enum Plain { first, second };
enum class Scoped { one = 1 };
double operator+(double x, Scoped y) { return x - static_cast<int>(y); }
template <class T> double operator*(Plain x, T y) { return x + 10 * y; }

template <class... T> static double sum(T... z) { return (z + ...); }
template <class T, class U> static double mixed(T x, U y) { return x / y - y * x; }
template <class T, class U> static bool is_less(T x, U y) { return x < y && y != x; }

#pragma symreal function input(x) range(0.5, 4) output(return)
double k(double x) {
  Mode const mode = on;
  if (is_less(mode, x) || !is_less(x, mode)) return x;
  return sum(x, mode, 2) + sum(off, x) + mixed(x, mode) + mixed(mode, x) + sum(x, Scoped::one) + second * x;
}
int main() { std::printf("%g\n", k(1.5)); }
