// A pack of bases is told as a pack.
// RUN: %same %s -- -std=c++17
// RUN: %rewrite %s -- -std=c++17 | FileCheck %s
// RUN: %symreal generate %s -o %t.c -- -std=c++17 && %symreal verify %s %t.c --samples=100 -- -std=c++17
#include <cstdio>
#include <variant>

// CHECK: struct Cases : Ts... { REAL_MEMBERS(public, static_cast<Ts const &>(*this)..., scale)
template <class... Ts> struct Cases : Ts... {
  using Ts::operator()...;
  double scale = 2;
};
template <class... Ts> Cases(Ts...) -> Cases<Ts...>;
// CHECK: struct Spread : Ts /* each */ ... { REAL_MEMBERS(public, static_cast<Ts const &>(*this)...)
template <class... Ts> struct Spread : Ts /* each */ ... {};
struct Left {
  double x = 1;
};
struct Right {
  double y = 2;
};

int main() {
  std::variant<double, int> number = 3.0;
  Spread<Left, Right> both;
  double x = 0.5, y;
#pragma symreal input(x)
  y = std::visit(Cases{[&](double d) { return d * x; }, [](int i) { return 1.0 * i; }}, number) + both.x * both.y;
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
