// The same in C++: text through a conversion, a mutable member of a constant, the address of a pointer's target as an
// integer, what is in a tuple, how many constants a view shows; what algorithms write behind v.begin() or an array's begin.
// RUN: rm -rf %t && mkdir %t
// RUN: not %symreal generate %s -o %t/ -- -std=c++20 -DREADS 2>&1 | FileCheck %s --implicit-check-not="error:"
// RUN: not %symreal generate %s -o %t/ -- -std=c++20 -DWRITES 2>&1 | FileCheck %s --check-prefix=WRITTEN --implicit-check-not="error:"
// RUN: ls %t | count 0
// RUN: cd %t && %symreal generate %s -o ./ -- -std=c++20
// RUN: cd %t && %symreal verify %s reads.c writes.c gives.c --samples=50 -- -std=c++20
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

struct Law {
  int order = 1;
  mutable double gain = 2;
};
static std::string mode = "slow";
static Law const law;
static int here, there, *place = &here;
static std::tuple<double, int> limits{2, 3};
static double const numbers[4] = {1, 2, 3, 4};
static std::span<double const> view(numbers, 2);
void change(int to) {
  mode[0] = static_cast<char>(to);
  law.gain = to;
  place = to != 0 ? &there : &here;
  limits = {to, to};
  view = std::span<double const>(numbers, 3);
}
#ifdef READS
#pragma symreal function input(x) output(return)
#else
#pragma symreal function input(x) constant(mode, law.gain, place, limits, view) output(return)
#endif
double reads(double x) {
  // CHECK-DAG: error: kernel 'reads' reads 'mode', which is neither input nor parameter [SYM017]
  if (std::string_view(mode) == "fast") return x;
  // CHECK-DAG: error: kernel 'reads' reads 'place', which is neither input nor parameter [SYM017]
  if (reinterpret_cast<std::uintptr_t>(place) == reinterpret_cast<std::uintptr_t>(&there)) return 2 * x;
  // CHECK-DAG: error: kernel 'reads' reads 'law.gain' (2), which is neither input nor parameter [SYM017]
  x *= law.order * law.gain;
  // CHECK-DAG: error: kernel 'reads' reads 'limits' (2, 3), which are neither input nor parameter [SYM017]
  x *= std::apply([](double a, int b) { return a * b; }, limits);
  // CHECK-DAG: error: kernel 'reads' reads 'view', which is neither input nor parameter [SYM017]
  return x * static_cast<double>(view.size());
}

static std::vector<int> copied = {1, 2};
static std::vector<double> moved = {1, 2};
static int filled[3], erased[3], made[2] = {1, 2};
static int const counts[2] = {1, 2};
int found() { return filled[0]++ + erased[0]++ + made[0]++ + copied[0]++ + static_cast<int>(moved[0]++); }
#ifdef WRITES
#pragma symreal function input(x) output(return)
#else
#pragma symreal function input(x) scratch(copied, moved, filled, erased, made) output(return)
#endif
double writes(double x) {
  // WRITTEN-DAG: error: the kernel writes 'copied', which is not an output [SYM053]
  std::copy(counts, counts + 2, copied.begin());
  double const numbers[2] = {1, 2};
  // WRITTEN-DAG: error: the kernel writes 'moved', which is not an output [SYM053]
  std::copy(numbers, numbers + 2, moved.begin());
  // WRITTEN-DAG: error: the kernel writes 'filled', which is not an output [SYM053]
  std::fill_n(filled, 3, 0);
  // WRITTEN-DAG: error: the kernel writes 'erased', which is not an output [SYM053]
  std::fill(erased, erased + 3, 0);
  // WRITTEN-DAG: error: the kernel writes 'made', which is not an output [SYM053]
  std::uninitialized_copy(counts, counts + 2, made);
  return 2 * x;
}

#ifndef WRITES
#pragma symreal function input(x) scratch(copied, filled, erased, made) output(return, moved[0:2])
#endif
double gives(double x) {
  std::copy(counts, counts + 2, copied.begin());
  double const numbers[2] = {x, 2 * x};
  std::copy(numbers, numbers + 2, moved.begin());
  std::fill_n(filled, 3, 0);
  std::fill(erased, erased + 3, 0);
  std::uninitialized_copy(counts, counts + 2, made);
  return 2 * x;
}

int main() { std::printf("%g %g %g\n", reads(0.5), writes(0.5), gives(0.5)); }
