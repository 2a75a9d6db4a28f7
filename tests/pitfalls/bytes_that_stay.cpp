// A REAL is as large as a double, so sizes, also as a literal 8, and what moves bytes keep their meaning.
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=100
// RUN: FileCheck %s --input-file=%t.c
#include <cstdio>
#include <cstdlib>
#include <cstring>

union Either {
  double number;
  char bytes[8];
};

// CHECK: = input[1] + (input[0] + input[0]);
#pragma symreal function input(x[0:2]) output(return)
double moved(double const *x) {
  double *copy = static_cast<double *>(std::malloc(2 * 8)), twice[2];
  std::memcpy(copy, x, 16);
  std::memmove(twice, copy, sizeof twice);
  std::memset(copy, 0, 2 * sizeof(double));
  Either either;
  either.number = twice[1];
  Either const other = either;
  double const sum = copy[0] + twice[0] + x[0] + other.number;
  std::free(copy);
  return sum;
}

int main() {
  double const x[2] = {0.5, 0.25};
  std::printf("%g %d\n", moved(x), static_cast<int>(sizeof(double) + sizeof(Either)));
}
