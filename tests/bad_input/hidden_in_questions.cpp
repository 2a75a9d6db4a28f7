// State that the kernel asks for otherwise than by reading a value: how many elements there are, how two pointers lie, text
// and integers through views, and what only seems never to change.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c -- -std=c++20 2>&1 | FileCheck %s --implicit-check-not="error:"
// RUN: not ls %t.c
#include <algorithm>
#include <cstdio>
#include <functional>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

static int array[20] = {1, 2, 3}, *middle = array + 1, *const first = array;
static int *end = array + 3;
static std::vector<double> none, some = {1, 2}, few = {1}, several = {1, 2, 3};
static std::span<int> view(array + 4, 2);
static int left = 3, right = 4;
static std::reference_wrapper<int> chosen = left;
static std::variant<int, float> choice;
static std::tuple<int, double> pair{1, 2.0};
static char letters[3] = "ab";
static int reached[4] = {1, 2, 3, 4}, through[4] = {1, 2, 3, 4};
static std::unique_ptr<double> const held = std::make_unique<double>(2.0);
struct Cache {
  int use() const { return ++uses; }
  mutable int uses = 0;
};
static Cache cache;
struct Registered {
  Registered() { all().push_back(this); }
  static std::vector<Registered *> &all() {
    static std::vector<Registered *> list;
    return list;
  }
  int value = 1;
};
static Registered registered;

void change() {
  array[1] = 5, end = array + 2, none.push_back(1), some.push_back(1), few.clear(), several.clear();
  chosen = right, choice = 1.5f, std::get<0>(pair) = 4, letters[0] = 'z', *held = 3, cache.use();
  int *last = reached + 3 - 1;
  *last = 7;
  const_cast<int &>(std::as_const(through)[1]) = 9;
  Registered::all()[0]->value = 6;
}

#pragma symreal function input(x) output(return)
double asked(double x) {
  double y = x;
  // CHECK-DAG: error: kernel 'asked' reads 'middle[0]' (2), which is neither input nor parameter [SYM017]
  y += middle[0];
  // CHECK-DAG: error: kernel 'asked' reads 'first[2]' (3), which is neither input nor parameter [SYM017]
  y += first[2];
  // CHECK-DAG: error: kernel 'asked' reads 'end', which is neither input nor parameter [SYM017]
  y += static_cast<double>(end - array);
  // CHECK-DAG: error: kernel 'asked' reads 'none', which is neither input nor parameter [SYM017]
  for (double one : none) y += one;
  // CHECK-DAG: error: kernel 'asked' reads 'some', which is neither input nor parameter [SYM017]
  // CHECK-DAG: error: kernel 'asked' reads 'some' (1, 2), which are neither input nor parameter [SYM017]
  y += static_cast<double>(std::ssize(some));
  // CHECK-DAG: error: kernel 'asked' reads 'few', which is neither input nor parameter [SYM017]
  // CHECK-DAG: error: kernel 'asked' reads 'few' (1), which is neither input nor parameter [SYM017]
  if (few.begin() != few.end()) y += 1;
  // CHECK-DAG: error: kernel 'asked' reads 'several', which is neither input nor parameter [SYM017]
  // CHECK-DAG: error: kernel 'asked' reads 'several' (1, 2, 3), which are neither input nor parameter [SYM017]
  if (!std::empty(several)) y += 2;
  // CHECK-DAG: error: kernel 'asked' reads 'array' (0), which is neither input nor parameter [SYM017]
  y += view[1];
  // CHECK-DAG: error: kernel 'asked' reads 'chosen' (3), which is neither input nor parameter [SYM017]
  y += chosen;
  // CHECK-DAG: error: kernel 'asked' reads 'choice', which is neither input nor parameter [SYM017]
  if (std::get_if<int>(&choice)) y += 4;
  // CHECK-DAG: error: kernel 'asked' reads 'letters', which is neither input nor parameter [SYM017]
  if (std::string_view(letters) == "ab") y += 8;
  // CHECK-DAG: error: kernel 'asked' reads '*held' (2), which is neither input nor parameter [SYM017]
  y += *held;
  // CHECK-DAG: error: kernel 'asked' reads 'reached' (3), which is neither input nor parameter [SYM017]
  y += reached[2];
  // CHECK-DAG: error: kernel 'asked' reads 'through' (2), which is neither input nor parameter [SYM017]
  y += through[1];
  // CHECK-DAG: error: kernel 'asked' reads 'cache' (0), which is neither input nor parameter [SYM017]
  y += cache.uses;
  // CHECK-DAG: error: kernel 'asked' reads 'registered' (1), which is neither input nor parameter [SYM017]
  return y + registered.value;
}

int main(int count, char **) {
  if (count > 5) change();
  std::printf("%g\n", asked(0.5));
}
