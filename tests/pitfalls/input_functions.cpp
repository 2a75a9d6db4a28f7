// What reads numbers from text makes ordinary ones: they may become inputs.
// RUN: %same %s
// RUN: echo "0.25 0.5 0.125" > %t.txt
// RUN: %symreal generate %s -o %t.c --stdin=%t.txt --run-on 2>&1 | FileCheck %s --implicit-check-not=error:
// RUN: %symreal verify %s %t.c --stdin=%t.txt --samples=100
// CHECK: program| 3.375
// CHECK: kernel sum
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

#pragma symreal function input(x[0:5]) output(return)
double sum(double const *x) { return x[0] + x[1] + x[2] + x[3] + x[4]; }

int main() {
  double x[5];
  if (std::scanf("%lf", &x[0]) != 1) return 1;
  std::cin >> x[1] >> x[2];
  x[3] = std::strtod("1.5", nullptr);
  std::istringstream("1") >> x[4];
  std::cout << sum(x) << std::endl;
}
