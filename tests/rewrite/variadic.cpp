// A variadic function of the program itself takes REALs where it reads them as numbers, values where it hands them on.
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
#include <cstdarg>
#include <cstdio>

double total(int n, ...) {
  va_list list;
  va_start(list, n);
  double sum = 0.0;
  // CHECK: for (int i = 0; i < n; i++) sum += va_arg(list, REAL);
  for (int i = 0; i < n; i++) sum += va_arg(list, double);
  va_end(list);
  return sum;
}
void message(char const *format, ...) {
  va_list list;
  va_start(list, format);
  std::vprintf(format, list);
  va_end(list);
}
void use(double x) {
  // CHECK: total(2, x, 1.0);
  total(2, x, 1.0);
  // CHECK: message("%g", REAL_VALUE(x));
  message("%g", x);
}
