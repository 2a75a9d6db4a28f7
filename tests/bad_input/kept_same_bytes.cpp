// A write of library code is lost also where it has found the same bytes in the recorded call: another one may find
// others.
// RUN: rm -rf %t && mkdir %t
// RUN: not %symreal generate %s -o %t/ -- -std=c++20 2>&1 | FileCheck %s --implicit-check-not="error:"
// RUN: not ls %t/*
// RUN: %symreal generate %s -o %t/k.c -- -std=c++20 -DALLOWED && %symreal verify %s %t/k.c --samples=50 -- -std=c++20 -DALLOWED
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <set>
#include <string>
#include <variant>
#include <vector>

struct Settings {
  int count = 1;
  float scale = 2;
};
static char text[16] = "abc", line[8] = "7";
static std::string word = "abc";
static std::vector<double> numbers;
static std::vector<int> integers(3), swapped;
static std::set<int> indices;
static std::variant<int, double> choice{3};
static std::shared_ptr<int> owned;
static Settings settings, others;
static int scanned = 12, exponent = 0, quotient = 1, copies[3] = {1, 2, 3};
static int const sources[3] = {1, 2, 3};
static double whole = 1;

// They are no state of the program where the pragma says so.
#ifdef ALLOWED
#pragma symreal function input(x) output(return)                                                                       \
    scratch(text, line, word, numbers, integers, swapped, indices, choice, owned, settings, others, scanned, exponent,     \
            quotient, copies, whole)
#else
#pragma symreal function input(x) output(return)
#endif
double kept(double x) {
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: the kernel writes 'text', which is not an output [SYM053]
  std::strcpy(text, "abc");
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: the kernel writes 'line', which is not an output [SYM053]
  std::sprintf(line, "%d", 7);
  // CHECK-DAG: error: the kernel writes 'word', which is not an output [SYM053]
  word = "abc";
  // CHECK-DAG: error: the kernel writes 'numbers', which is not an output [SYM053]
  numbers.clear();
  // CHECK-DAG: error: the kernel writes 'integers', which is not an output [SYM053]
  integers.resize(3);
  // CHECK-DAG: error: the kernel writes 'swapped', which is not an output [SYM053]
  std::vector<int>().swap(swapped);
  // CHECK-DAG: error: the kernel writes 'indices', which is not an output [SYM053]
  indices.clear();
  // CHECK-DAG: error: the kernel writes 'choice', which is not an output [SYM053]
  choice.emplace<0>(3);
  // CHECK-DAG: error: the kernel writes 'owned', which is not an output [SYM053]
  owned = nullptr;
  // CHECK-DAG: error: the kernel writes 'settings', which is not an output [SYM053]
  ::new (static_cast<void *>(&settings)) Settings;
  // CHECK-DAG: error: the kernel writes 'others', which is not an output [SYM053]
  std::construct_at(&others);
  // CHECK-DAG: error: the kernel writes 'scanned', which is not an output [SYM053]
  std::sscanf("12", "%d", &scanned);
  // CHECK-DAG: error: the kernel writes 'exponent', which is not an output [SYM053]
  double y = std::frexp(0.75, &exponent);
  // CHECK-DAG: error: the kernel writes 'quotient', which is not an output [SYM053]
  y += std::remquo(3.1, 3.0, &quotient);
  // CHECK-DAG: error: the kernel writes 'copies', which is not an output [SYM053]
  std::copy_n(sources, 3, copies);
  // CHECK-DAG: error: the kernel writes 'whole', which is not an output [SYM053]
  y += std::modf(1.5, &whole);
  return x * y;
}

int main() { std::printf("%g\n", kept(0.5)); }
