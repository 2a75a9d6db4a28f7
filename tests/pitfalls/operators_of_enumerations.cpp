// An operator that the program has for an integer and an enumeration is taken for a symbolic integer as well; for other
// enumerations it is the language's.
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=100 2>&1 | FileCheck %s
// CHECK: value_return {{ *}}1 {{ *}}0 {{ *}}0
#include <cmath>
#include <cstdio>

namespace times {
enum Unit { days = 1, weeks = 7 };
struct Period {
  double length;
};
template <class T> Period operator*(T count, Unit unit) { return {1000.0 * count * static_cast<int>(unit)}; }
template <class T> Period operator*(Unit unit, T count) { return {2000.0 * count * static_cast<int>(unit)}; }
} // namespace times
enum Factor { twice = 2 };

#pragma symreal function input(x) range(1, 9) output(return)
double kernel(double x) {
  auto const count = (int)std::lround(x);
  return (count * times::weeks).length + (times::days * count).length + (count + times::weeks) + count * twice +
         twice * count;
}

int main() { std::printf("%g\n", kernel(2.5)); }
