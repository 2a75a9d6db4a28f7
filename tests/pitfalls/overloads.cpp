// A literal chooses the same overload, constructor and initializer list with REAL as with double.
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=100
// RUN: FileCheck %s --input-file=%t.c
#include <cstdio>
#include <utility>
#include <vector>

static double pick(long) { return 100.0; }
static double pick(double x) { return x; }
template <class T> double size_of_list(std::vector<T> const &v) { return static_cast<double>(v.size()); }
static double first(std::vector<double> const &v) { return v.empty() ? -1.0 : v[0]; }

// CHECK: = input[0] + 2.5 + 1.0 + 3.0 + 2.0 + 2.0 + 1.5 + 2.5;
#pragma symreal function input(x) output(return)
double sum(double x) {
  std::vector<double> const one{2.0}, three(3, 1.0);
  auto const pair = std::make_pair(1.5, 2.0);
  return x + pick(2.5) + size_of_list(one) + size_of_list(three) + first({2.0}) + first(one) + pair.first + 2.5;
}

int main() { std::printf("%g\n", sum(0.5)); }
