// An enumerator becomes a number also where the expression depends on a template: a fold over one enumerator is that one.
// RUN: %same %s -- -std=c++20
// RUN: %symreal generate %s -o %t.c -- -std=c++20 && %symreal verify %s %t.c --samples=100 -- -std=c++20
#include <cstdio>

enum Color { red = 1, green = 2, blue = 4 };
enum class Scoped { one = 3 };

template <Color... values> double sum() { return (... + values); }
template <Color... values> double product() {
  double result = (values * ...);
  result += sum<values...>();
  return result;
}
static double taken(double x) { return x / 2; }
template <class... T> double passed(T... values) { return taken((... + values)) + taken((values, ...)); }
template <auto value> double single() {
  if constexpr (requires { +value; })
    return value;
  else
    return static_cast<double>(value);
}
template <class T> struct Weighted {
  double weight = T::value;
  double operator()(double x) const { return x * weight; }
};
struct Green {
  static constexpr Color value = green;
};

#pragma symreal function input(x) output(return)
double kernel(double x) {
  double y = sum<red>() * x + sum<red, blue>() + product<green>() * x + product<green, blue>();
  y += passed(blue) + passed(red, green) * x + single<blue>() + single<Scoped::one>() * x;
  return y + Weighted<Green>{}(x);
}

int main() { std::printf("%g\n", kernel(0.5)); }
