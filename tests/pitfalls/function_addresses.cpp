// A function of the mathematical library has one address under each of its names, also through templates, containers and
// std::function, and in what the program's own functions are kept.
// RUN: %same %s -- -std=c++20
// RUN: %symreal generate %s -o %t.c -- -std=c++20 && %symreal verify %s %t.c --samples=50 -- -std=c++20
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <map>
#include <unordered_map>
#include <vector>

using Unary = double (*)(double);
using Binary = double (*)(double, double);

static double twice(double x) { return 2 * x; }

template <Unary f> double applied(double x) { return f == static_cast<Unary>(std::sin) ? 3 * f(x) : f(x); }

template <class T> T of_number(T (*f)(T), T x) {
  T (*sine)(T) = std::sin;
  return f == sine ? 5 * f(x) : f(x);
}

template <class F> double by_value(F f, double x) { return f == ::cos ? 7 * f(x) : f(x); }

static double pick(Unary f, double x) { return f == (Unary)std::sin ? 10 * x : f == &twice ? 20 * x : f(x); }

static double chosen(std::uintptr_t address, double x) {
  std::uintptr_t const known[] = {(std::uintptr_t)(Unary)std::exp, (std::uintptr_t)twice};
  return std::find(known, known + 2, address) - known + x;
}

#pragma symreal function input(x) range(0.2, 0.9) output(return)
double sum(double x) {
  std::unordered_map<Unary, double> weights = {{std::sin, 2}, {std::cos, 3}, {twice, 4}};
  std::map<Binary, int> const ranks = {{std::pow, 1}, {std::atan2, 2}, {std::fmod, 3}};
  std::vector<Unary> const list = {std::tan, std::sqrt, twice, std::fabs};
  std::function<double(double)> const kept = static_cast<Unary>(std::sqrt);
  Unary const *target = kept.target<Unary>();
  double y = pick(std::sin, x) + pick(::sin, x) + pick(std::cos, x) + pick(twice, x);
  y += applied<std::sin>(x) + applied<std::cos>(x) + applied<twice>(x);
  y += of_number<double>(std::sin, x) + of_number<double>(twice, x) + by_value<Unary>(std::cos, x);
  y += weights[std::sin] * x + weights[std::cos] + weights.at(::sin) + weights[&twice] * x;
  y += ranks.at(std::pow) * x + ranks.at(static_cast<Binary>(std::fmod)) + ranks.at(std::atan2);
  y += static_cast<double>(std::find(list.begin(), list.end(), static_cast<Unary>(std::sqrt)) - list.begin());
  y += target && *target == static_cast<Unary>(std::sqrt) ? x : 1e6;
  y += chosen((std::uintptr_t)(Unary)std::exp, x) + chosen((std::uintptr_t)&twice, x);
  return y + (static_cast<Unary>(std::fabs) == static_cast<Unary>(std::abs)) + std::hash<Unary>()(std::log) % 1;
}

int main() { std::printf("%.17g\n", sum(0.5)); }
