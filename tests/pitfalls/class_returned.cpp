// A class that converts to double, returned as one, is the number that it converts to.
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=100
#include <cstdio>

struct Metres {
  double value;
  operator double() const { return value; }
  Metres operator+(Metres other) const { return {value + other.value}; }
};

#pragma symreal function input(x) output(return)
double twice(double x) {
  Metres const a{x};
  return a + a;
}

int main() { std::printf("%g\n", twice(0.5)); }
