// Constants that the kernel itself names are none of its caller's choice, however it gets to their elements.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %s -o %t/ -- -std=c++20 2>&1 | FileCheck %s --implicit-check-not="error:"
// RUN: %symreal verify %s %t/sums.c --kernel sums --samples=200 -- -std=c++20
// RUN: %symreal verify %s %t/block.c --kernel block --samples=200 -- -std=c++20
// CHECK: kernel sums: 1 inputs
#include <array>
#include <cstdio>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

static double const low[3] = {1, 2, 3}, high[3] = {4, 5, 6};
struct Model {
  double a, b;
};
static Model const first = {1, 2}, second = {4, 5};
struct Horner {
  Model const &model;
  double const *table;
  double operator()(double x) const { return model.a + model.b * x + table[1]; }
};
struct View {
  std::span<double const> numbers;
};

static double sum(std::vector<double const *> const &tables) {
  double y = 0;
  for (double const *one : tables) y += *one;
  return y;
}
static double sum_of(View const &view) {
  double y = 0;
  for (double one : view.numbers) y += one;
  return y;
}
static double all(Horner const *horner, Model const &model, double const *table, double x) {
  Horner copy = *horner;
  return (*horner)(x) + copy(x) + model.b * table[2];
}

// Text and functions are the caller's, and are compared by a wrapper.
#pragma symreal function input(x) output(return)
double sums(std::string_view name, char const *other, std::function<double(double)> const &function, double x) {
  std::span<double const> numbers(low), behind = numbers.subspan(1);
  double y = numbers[0];
  for (auto at = behind.begin(); at != behind.end(); ++at) y += *at * x;
  std::vector<double const *> tables = {low, high}, others = tables;
  auto [table, n] = std::tuple<double const *, int>(high, 1);
  std::reference_wrapper<Model const> model(second);
  std::shared_ptr<Model const> shared(&first, [](Model const *) {});
  Horner horner = {first, low};
  y += sum(others) + sum_of({high}) + table[n] + model.get().a * shared->b + Horner{second, high}(x);
  return (y + all(&horner, second, high, x)) * (name == "a" ? 2 : 3) * (other[0] == 'b') + function(x);
}

// The code before a block has no choice where there is but one constant.
double block(double x) {
  double const *const table = low;
  double const *at = high;
  Model const &model = first;
  double y;
#pragma symreal input(x)
  y = x * table[1] + *at++;
  y += *at * model.b;
#pragma symreal output(y) generate("block.c")
  return y;
}

int main() { std::printf("%g\n", sums("a", "b", [](double v) { return v * low[1]; }, 0.5) + block(0.5)); }
