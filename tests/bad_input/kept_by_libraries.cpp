// Code of libraries is not rewritten: what it leaves in the memory of the kernel's callers shows in that memory.
// RUN: not %symreal generate %s -o %t/ --run-on 2>&1 | FileCheck %s
// RUN: not ls %t
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#ifdef ALLOWED
// An output may grow, and scratch is scratch.
// RUN: %symreal generate %s -o %t.c -- -DALLOWED && %symreal verify %s %t.c --samples=50 -- -DALLOWED
#pragma symreal function input(x) scratch(work[0:2]) output(return, result)
double allowed(double x, std::vector<double> &result, double *work) {
  result.assign(5, 1.5);
  result[0] = x;
  std::fill(work, work + 2, 3.0);
  return x * 2;
}
int main() {
  double numbers[2] = {1, 2};
  std::vector<double> result(4, 1.0);
  std::printf("%g\n", allowed(0.5, result, numbers));
}

#else
// CHECK-DAG: kept_by_libraries.cpp:[[@LINE+3]]:13: error: the kernel writes 'work', which is not an output [SYM053]
#pragma symreal function input(x) output(return)
double filled(double x, double *work) {
  std::fill(work, work + 2, 3.0);
  return x * 2;
}
// CHECK-DAG: kept_by_libraries.cpp:[[@LINE+3]]:15: error: the kernel writes 'work', which is not an output [SYM053]
#pragma symreal function input(x) output(return)
double filled_heap(double x, std::vector<double> &work) {
  std::fill_n(work.begin(), 2, 7.0);
  return x * 2;
}
// CHECK-DAG: kept_by_libraries.cpp:[[@LINE+4]]:29: error: the kernel writes 'work', which is not an output [SYM053]
#pragma symreal function input(x) output(return)
double copied(double x, double *work) {
  double const from[2] = {x, 2};
  std::copy(from, from + 2, work);
  return x * 2;
}
// CHECK-DAG: kept_by_libraries.cpp:[[@LINE+3]]:3: error: the kernel writes 'work', which is not an output
#pragma symreal function input(x) output(return)
double cleared(double x, int *work) {
  std::memset(work, 0, 2 * sizeof *work);
  return x * 2;
}
// CHECK-DAG: kept_by_libraries.cpp:[[@LINE+3]]:27: error: the kernel writes 'work', which is not an output
#pragma symreal function input(x) output(return)
double sorted(double x, std::array<int, 3> &work) {
  std::sort(work.begin(), work.end());
  return x * 2;
}
// CHECK-DAG: kept_by_libraries.cpp:[[@LINE+1]]:1: error: the kernel changes {{[0-9]+}} bytes in a variable of a calling function
#pragma symreal function input(x) output(return)
double printed(double x, char *work) {
  std::sprintf(work, "%d", 42);
  return x * 2;
}
// CHECK-DAG: kept_by_libraries.cpp:[[@LINE+1]]:1: error: the kernel changes {{[0-9]+}} bytes in a variable of a calling function
#pragma symreal function input(x) output(return)
double grown(double x, std::vector<int> &work) {
  work.push_back(3);
  return x * 2;
}
// CHECK-DAG: kept_by_libraries.cpp:[[@LINE+1]]:1: error: the kernel changes {{[0-9]+}} bytes in a variable of a calling function
#pragma symreal function input(x) output(return)
double bits(double x, std::vector<bool> &work) {
  work.push_back(true);
  return x * 2;
}
// CHECK-DAG: kept_by_libraries.cpp:[[@LINE+1]]:1: error: the kernel changes {{[0-9]+}} bytes in a variable of a calling function
#pragma symreal function input(x) output(return)
double named(double x, std::string &work) {
  work += "x";
  return x * 2;
}
// CHECK-DAG: kept_by_libraries.cpp:[[@LINE+3]]:3: error: the kernel writes 'work', which is not an output [SYM053]
#pragma symreal function input(x) output(return)
double owned(double x, std::unique_ptr<int> &work) {
  work.reset(new int(4));
  return x * 2;
}
// CHECK-DAG: kept_by_libraries.cpp:[[@LINE+1]]:1: error: the kernel changes {{.*}} on the heap
#pragma symreal function input(x) output(return)
double numbered(double x, int *work) {
  std::fill_n(work, 3, 5);
  return x * 2;
}
int main() {
  double numbers[2] = {1, 2};
  int integers[2] = {1, 2};
  std::array<int, 3> unordered{3, 1, 2};
  char text[16] = "none";
  std::vector<double> heap(4, 1.0);
  std::vector<int> list;
  std::vector<bool> flags;
  std::string name;
  std::unique_ptr<int> pointer;
  auto const block = std::make_unique<int[]>(3);
  double sum = filled(0.5, numbers) + filled_heap(0.5, heap) + copied(0.5, numbers) + cleared(0.5, integers) +
               sorted(0.5, unordered) + printed(0.5, text) + grown(0.5, list) + bits(0.5, flags) + named(0.5, name) +
               owned(0.5, pointer) + numbered(0.5, block.get());
  std::printf("%g\n", sum);
}
#endif
