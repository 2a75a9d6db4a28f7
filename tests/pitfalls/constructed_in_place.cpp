// Numbers that a library hands on to a constructor of the program's, several at once.
// RUN: rm -rf %t && mkdir %t && cd %t && %symreal generate %s -o line.c 2> log && FileCheck %s < line.c
// RUN: cd %t && %symreal verify --samples=100 --min-samples=10 %s line.c
// RUN: %same %s
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <vector>

struct Line {
  Line(double a, double b, int n) : slope(a), offset(b), times(n) {}
  double at(double x) const { return times * (slope * x + offset); }
  double slope, offset;
  int times;
};

#pragma symreal function input(x, y) output(return)
double kernel(double x, double y) {
  auto const one = std::make_unique<Line>(x, y, 2);
  std::vector<Line> lines;
  lines.emplace_back(y, 3.0, 4);
  std::map<int, Line> named;
  named.try_emplace(1, x, 2.5, 6);
  std::optional<Line> maybe;
  maybe.emplace(x, y, 5);
  auto const shared = std::make_shared<Line>(1.0, x, 7);
  // CHECK-COUNT-2: 2.0
  return one->at(y) + lines[0].at(x) + named.at(1).at(y) + maybe->at(2) + shared->at(y);
}

int main() { std::printf("%g\n", kernel(0.5, 0.25)); }
