// Constants that the kernel does not name itself: its caller hands them over, or a pointer leads to them, so that the
// next call may meet others.
// RUN: rm -rf %t && mkdir %t
// RUN: not %symreal generate %s -o %t/ -- -std=c++20 2>&1 | FileCheck %s --implicit-check-not="error:"
// RUN: not ls %t/*
// Elements that constant(...) names may stay.
// RUN: %symreal generate %s --kernel pointers -o %t.c -- -std=c++20 -DNAMED && %symreal verify %s %t.c --kernel pointers --samples=50 -- -std=c++20 -DNAMED
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

static double const low[3] = {1, 2, 3}, high[3] = {4, 5, 6};
static double const rows[2][3] = {{1, 2, 3}, {4, 5, 6}};
static int const count = 3;
static double const gravity = 9.81;
struct Model {
  double a, b;
  int mode;
  double of(double x) const;
};
static Model const first = {1, 2, 3}, second = {4, 5, 6};
struct Table {
  double const *begin;
};
struct View {
  std::span<double const> numbers;
};
struct Holder {
  Model const &model;
  double scaled(double x) const;
};

#ifdef NAMED
#pragma symreal function constant(table[0:3], lines[0:2][0:3]) input(x) output(return)
#else
#pragma symreal function input(x) output(return)
#endif
double pointers(double const *table, double const (*lines)[3], double x) {
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'pointers' reads 'table[1]' (2), which is neither input nor parameter [SYM017]
  double y = x * table[1];
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'pointers' reads 'lines[1]' (4, 5, 6), which are neither input nor parameter [SYM017]
  for (double one : lines[1]) y += one;
  return y;
}

#pragma symreal function input(x) output(return)
double references(Model const &model, double const (&three)[3], int const &n, double const &g, double x) {
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'references' reads 'model.a' (1), which is neither input nor parameter [SYM017]
  double y = x * model.a;
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'references' reads 'model.mode' (3), which is neither input nor parameter [SYM017]
  if (model.mode == 3) y += 1;
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'references' reads 'three[2]' (6), which is neither input nor parameter [SYM017]
  y += three[2];
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'references' reads 'n' (3), which is neither input nor parameter [SYM017]
  y *= n;
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'references' reads 'g' (9.81), which is neither input nor parameter [SYM017]
  return y + g;
}

#pragma symreal function input(x) output(return)
double by_default(double x, double const *table = low) {
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'by_default' reads 'table[1]' (2), which is neither input nor parameter [SYM017]
  return x * table[1];
}

#pragma symreal function input(x) output(return)
double structure(Table table, std::tuple<double const *, int> pair, double x) {
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'structure' reads 'table.begin[0]' (1), which is neither input nor parameter [SYM017]
  double y = x * table.begin[0];
  auto [numbers, n] = pair;
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'structure' reads 'numbers[n]' (5), which is neither input nor parameter [SYM017]
  return y + numbers[n];
}

#pragma symreal function input(x) output(return)
double views(std::span<double const> numbers, View const &view, View const *other, double x) {
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'views' reads 'numbers.back()' (3), which is neither input nor parameter [SYM017]
  double y = x * numbers.back();
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'views' reads 'view.numbers[1]' (5), which is neither input nor parameter [SYM017]
  y += view.numbers[1];
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'views' reads 'other->numbers' (1, 2), which are neither input nor parameter [SYM017]
  for (double one : other->numbers) y += one;
  return y;
}

#pragma symreal function input(x) output(return)
double copies(Table const *table, Table const &other, std::vector<double const *> const &list, double x) {
  Table mine = *table, moved;
  std::memcpy(&moved, &other, sizeof moved);
  auto numbers = list;
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'copies' reads 'mine.begin[0]' (1), which is neither input nor parameter [SYM017]
  double y = x * mine.begin[0];
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'copies' reads 'moved.begin[2]' (6), which is neither input nor parameter [SYM017]
  y += moved.begin[2];
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'copies' reads 'numbers[0][1]' (2), which is neither input nor parameter [SYM017]
  return y + numbers[0][1];
}

#pragma symreal function input(x) output(return)
double shared(std::shared_ptr<Model const> const &model, std::vector<std::reference_wrapper<Model const>> const &list, double x) {
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'shared' reads 'model->a' (1), which is neither input nor parameter [SYM017]
  return x * model->a
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'shared' reads 'list[0].get().b' (5), which is neither input nor parameter [SYM017]
    + list[0].get().b;
}

#pragma symreal function input(x) output(return)
double Model::of(double x) const {
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'of' reads 'a' (1), which is neither input nor parameter [SYM017]
  return a * x;
}

#pragma symreal function input(x) output(return)
double Holder::scaled(double x) const {
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'scaled' reads 'model.b' (5), which is neither input nor parameter [SYM017]
  return model.b * x;
}

static std::span<double const> current = low;
void choose() { current = high; }
static Holder *holder = new Holder{first};
#pragma symreal function input(x) output(return)
double lasting(double x) {
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'lasting' reads 'current[1]' (2), which is neither input nor parameter [SYM017]
  return current[1] * x
    // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'lasting' reads 'holder->model.a' (1), which is neither input nor parameter [SYM017]
    + holder->model.a;
}

// The code before a block chooses as well.
double block(int k, double x) {
  double const *table = k ? low : high, *at = low;
  if (k > 5) at = high;
  Model const &model = k ? first : second;
  std::span<double const> view(k ? low : high, 3);
  Table copied = {k ? high : low};
  double y;
#ifndef NAMED
#pragma symreal input(x)
#endif
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'block' reads 'table[1]' (2), which is neither input nor parameter [SYM017]
  y = x * table[1];
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'block' reads 'at[0]' (1), which is neither input nor parameter [SYM017]
  y += at[0];
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'block' reads 'model.b' (2), which is neither input nor parameter [SYM017]
  y += model.b;
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'block' reads 'view[2]' (3), which is neither input nor parameter [SYM017]
  y += view[2];
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'block' reads 'copied.begin[0]' (4), which is neither input nor parameter [SYM017]
  y += copied.begin[0];
#ifndef NAMED
#pragma symreal output(y) generate("block.c")
#endif
  return y;
}

int main(int argc, char **) {
  double const x = 0.5;
  View const view = {high}, other = {low};
  Table const table = {low};
  double y = 0;
  y += pointers(low, rows, x);
  y += references(first, high, count, gravity, x);
  y += by_default(x);
  y += structure({low}, {high, 1}, x);
  y += views(low, view, &other, x);
  y += copies(&table, {high}, {low}, x);
  y += shared({&first, [](Model const *) {}}, {second}, x);
  y += first.of(x) + Holder{second}.scaled(x) + lasting(x) + block(argc, x);
  std::printf("%g\n", y);
}
