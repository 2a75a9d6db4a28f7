// Some types have another name in the symbolic program than in the original: a kernel that asks for one is told. One that
// compares them is not, nor is a program that asks outside of the kernel.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not=SYM198
// RUN: not ls %t.c
#include <cstdio>
#include <typeinfo>

template <class T> auto rank(T x) -> decltype(x * x) {
  struct Local {};
  // CHECK-DAG: names_of_types.cpp:[[@LINE+1]]:10: error: the name, hash or order is asked for of a type that has another name in the original [SYM198]
  return typeid(Local).name()[4] * x;
}

#pragma symreal function input(x) output(return)
double kernel(double x) {
  auto const twice = [](double y) { return 2 * y; };
  // CHECK-DAG: names_of_types.cpp:[[@LINE+1]]:32: error: the name, hash or order is asked for of a type that has another name in the original [SYM198]
  double const of_lambda = x * typeid(twice).hash_code();
  return twice(x) + of_lambda + rank(x) + (typeid(twice) == typeid(rank<double>));
}

int main() {
  auto const half = [](double y) { return y / 2; };
  std::printf("%s\n", typeid(half).name());
  std::printf("%.17g\n", kernel(0.5));
}
