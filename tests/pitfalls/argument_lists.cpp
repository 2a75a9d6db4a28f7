// The same in C++: lists that templates, lambdas, virtual functions and objects read.
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=100
// RUN: FileCheck %s --input-file=%t.c
#include <cstdarg>
#include <cstdio>
#include <functional>

template <class T> T next(std::va_list *list) { return va_arg(*list, T); }
static double of_template(int n, ...) {
  std::va_list list;
  va_start(list, n);
  double product = next<double>(&list);
  while (--n > 0) product *= next<double>(&list);
  va_end(list);
  return product;
}
static double of_lambda(int n, ...) {
  std::va_list list;
  va_start(list, n);
  auto const read = [&list] { return va_arg(list, double); };
  double sum = 0;
  while (n-- > 0) sum = 2 * sum + read();
  va_end(list);
  return sum;
}
static double of_function(int n, ...) {
  std::function<double(std::va_list)> const read = [](std::va_list list) { return va_arg(list, double); };
  std::va_list list;
  va_start(list, n);
  double const first = read(list);
  va_end(list);
  return first;
}
struct Reader {
  virtual ~Reader() = default;
  virtual double read(std::va_list list) const = 0;
  double operator()(int n, ...) const {
    std::va_list list;
    va_start(list, n);
    double const result = read(list);
    va_end(list);
    return result;
  }
};
struct Difference : Reader {
  double read(std::va_list list) const override {
    double const first = va_arg(list, double);
    return first - va_arg(list, double);
  }
};
struct View {
  std::va_list &list;
  double read() { return va_arg(list, double); }
};
static double of_view(int n, ...) {
  std::va_list list;
  va_start(list, n);
  View view{list};
  double const first = view.read(), second = view.read();
  va_end(list);
  return first / second;
}
struct Ignoring {
  virtual ~Ignoring() = default;
  virtual double last(int, ...) const { return 0; }
};
struct Reading : Ignoring {
  double last(int n, ...) const override {
    std::va_list list;
    va_start(list, n);
    double result = 0;
    while (n-- > 0) result = va_arg(list, double);
    va_end(list);
    return result;
  }
};
static auto const sum = [](int n, ...) {
  std::va_list list;
  va_start(list, n);
  double result = 0;
  while (n-- > 0) result += va_arg(list, double);
  va_end(list);
  return result;
};
template <class T> double called_in_template(T x) { return of_template(2, x, x + 1); }

// CHECK: input[0]
// CHECK: input[1]
#pragma symreal function input(a, b) range(0.5, 2) output(return)
double kernel(double a, double b) {
  double (*const pointer)(int, ...) = of_lambda;
  return of_template(2, a, b) + of_lambda(2, b, 3.0) + of_function(1, a) + Difference{}(2, a, b) + of_view(2, a, b) +
         called_in_template(b) + pointer(2, a, a) + sum(2, a, b) + static_cast<Ignoring const &>(Reading()).last(2, a, b);
}

int main() { std::printf("%.17g\n", kernel(0.7, 1.3)); }
