// A class that is made of an integer has operators with numbers: those of a plain number and a REAL stay the numbers'.
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=100
// RUN: FileCheck %s --input-file=%t.c
#include <cstdio>
#include <limits>

struct Vector {
  Vector(int size) : size(size) {}
  int size;
};
static Vector operator+(Vector const &v, double const &) { return v; }
static Vector operator-(Vector const &v, double const &) { return v; }
static Vector operator*(Vector const &v, double const &) { return v; }
static Vector operator/(double const &, Vector const &v) { return v; }

static double const tiny = 5 * std::numeric_limits<double>::epsilon();

// CHECK: = input[0]*2.0 - input[0]*0.9999999999999989;
#pragma symreal function input(x) output(return)
double sum(double x) {
  int const two = 2;
  double const limit = 3 + std::numeric_limits<double>::epsilon() / two - (4 - std::numeric_limits<double>::epsilon());
  return x * (tiny + limit) + two * x;
}

int main() { std::printf("%g %d\n", sum(0.5), (Vector(3) + 1.0 - 2.0).size + (Vector(1) * 2.0).size + (1.0 / Vector(2)).size); }
