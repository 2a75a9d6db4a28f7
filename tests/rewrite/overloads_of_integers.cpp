// Functions of several types, given an integer that counts truth values of numbers: as for an int, one of them is best.
// RUN: %symreal generate %s -o %t.c --decisions=guard && FileCheck %s < %t.c
// RUN: %symreal verify --samples=100 --min-samples=1 %s %t.c 2>&1 | FileCheck %s --check-prefix=VERIFY
// CHECK: x > y is false
// VERIFY: value_return {{ *}}1 {{ *}}0 {{ *}}0
#include <cstdlib>

struct number {
  double d;
  number(double z) : d(z) {}
};
static double law(number const &z) { return z.d * 3 - 1; }
static double law(int z) { return z * 0.5; }
static double law(long z) { return z * 3.0 + 1; }
static double law(unsigned z) { return z * 2.0 + 2; }
static double law(double z) { return z * 3 + 3; }

static double wider(long const &z, double v) { return static_cast<double>(z) + v; }
static double wider(number z, double v) { return z.d - v; }

struct pair {
  double d;
  explicit pair(int n) : d(n) {}
  explicit pair(double v) : d(-v) {}
};
static pair operator*(pair a, int n) { return pair(a.d + n); }
static pair operator*(pair a, double n) { return pair(a.d - n); }

template <class T> static double beside(double x, T t) { return law((x > 1) + t); }
template <class T> static double chosen(bool flag, double x, T t) { return flag ? t : (x > 1) + t; }
template <class T> static double both(T x, T y) { return law((x > y) + 1) + law((x > y) - (y > T(1))); }

#pragma symreal function input(x, y) range(-2, 2) constant(word) output(return)
double k(double x, double y, char const *word) {
  int const n = *word == 'a', m = static_cast<int>(3 * x);
  double const of_arithmetic = law(std::abs(n) - (x > y)) + law((x > 1) * 2u) + law(1L + (x > 1)) + law(-(x > y));
  double const of_others = law(m) + law(m + (x > y)) + law(x > 1) + law(n ? (x > 1) + 1 : 3);
  double const converted = wider((x > 1) + 2, y) + pair((x > y) + 1).d + (pair(1.5) * ((x > y) + 1)).d;
  return x + of_arithmetic + of_others + converted + both(x, y) + beside(x, 2) +
         beside(x, 2.75) + chosen(n, x, 2) + chosen(n, x, 2.75) + both(1, 2) + both(2.0F, 1.0F);
}

int main() { return k(0.3, 0.5, "a") > 100; }
