// Type(factor) * (sum): what is put around the factor must not read as a cast to a function.
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s
// RUN: %same %s
// CHECK: value_return {{ *}}1 {{ *}}0 {{ *}}0
#include <cstdio>
typedef int Integer;
struct Handle {
  Handle(int) {}
};
Handle operator*(Handle const &h, double) { return h; }
struct Option {
  enum Type { put = -1, call = 1 };
};

#pragma symreal function input(forward, strike) constant(type) output(return)
double money(Option::Type type, double forward, double strike) {
  double const delta = Integer(type) * (forward - strike);
  return (forward - strike) * Integer(type) + delta;
}

int main() { std::printf("%g\n", money(Option::call, 1.5, 0.5)); }
