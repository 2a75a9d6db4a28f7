// Objects of library classes that Symreal knows nothing of, and that the program can change, are state where a function of
// theirs tells the kernel what they hold.
// RUN: rm -rf %t && mkdir %t
// RUN: not %symreal generate %s -o %t/ -- -DUNNAMED 2>&1 | FileCheck %s --implicit-check-not="error:"
// RUN: ls %t | count 0
// What constant(...) names, and what the program never changes, may stay.
// RUN: cd %t && %symreal generate %s -o ./ && %symreal verify %s scaled.c unchanged.c --samples=50
#include <chrono>
#include <complex>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <mutex>
#include <random>
#include <string_view>
#include <system_error>
#include <typeindex>

struct Law {
  double same(double x) const { return x; }
  double twice(double x) const { return 2 * x; }
};
static auto method = std::mem_fn(&Law::same);
static std::chrono::steady_clock::time_point start;
static std::type_index type = typeid(int);
static std::error_code failure;
static std::filesystem::path path = "a";
// CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'scaled' reads 'single' (1, 2), which are neither input nor parameter [SYM017]
static std::complex<float> single(1, 2);
static std::string_view word = "slow";
static std::uniform_int_distribution<int> dice(1, 6);
static std::normal_distribution<double> bell(1, 2);
static std::mutex mutex; // holds no value
static std::string_view shown = "shown";

void change() {
  method = std::mem_fn(&Law::twice), start += std::chrono::seconds(3), type = typeid(double), path = "b";
  failure = std::make_error_code(std::errc::invalid_argument), single = {3, 4}, word = "fast", shown = "other";
  dice = std::uniform_int_distribution<int>(2, 3), bell = std::normal_distribution<double>(3, 4);
}

#ifdef UNNAMED
#pragma symreal function input(x) output(return)
#else
#pragma symreal function input(x) output(return)                                                                       \
    constant(method, start, type, failure, path, single, word, dice, bell)
#endif
double scaled(double x) {
  std::lock_guard<std::mutex> const lock(mutex);
  std::cout << shown << "\n";
  // CHECK-DAG: :[[#@LINE+2]]:{{[0-9]+}}: error: kernel 'scaled' reads 'method', which is neither input nor parameter [SYM017]
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'scaled' reads 'start', which is neither input nor parameter [SYM017]
  double y = method(Law(), x) + static_cast<double>(start.time_since_epoch().count());
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'scaled' reads 'type', which is neither input nor parameter [SYM017]
  if (type == std::type_index(typeid(int))) y += 1;
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'scaled' reads 'failure', which is neither input nor parameter [SYM017]
  if (failure) y += 2;
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'scaled' reads 'path', which is neither input nor parameter [SYM017]
  if (path == "a") y += 4;
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'scaled' reads 'word', which is neither input nor parameter [SYM017]
  if (word == "slow") y += 8;
  std::chrono::steady_clock::time_point const made = std::chrono::steady_clock::time_point() + std::chrono::seconds(1);
  if (made == std::chrono::steady_clock::time_point()) y += 16;
  // CHECK-DAG: :[[#@LINE+2]]:{{[0-9]+}}: error: kernel 'scaled' reads 'dice', which is neither input nor parameter [SYM017]
  // CHECK-DAG: :[[#@LINE+1]]:{{[0-9]+}}: error: kernel 'scaled' reads 'bell', which is neither input nor parameter [SYM017]
  return y + single.real() + dice.max() + bell.mean();
}

namespace never {
static auto method = std::mem_fn(&Law::same);
static std::chrono::steady_clock::time_point start;
static std::type_index type = typeid(int);
static std::error_code failure;
static std::filesystem::path path = "a";
static std::complex<float> single(1, 2);
static std::string_view word = "slow";
static std::uniform_int_distribution<int> dice(1, 6);
static std::normal_distribution<double> bell(1, 2);
#pragma symreal function input(x) output(return)
double unchanged(double x) {
  double y = method(Law(), x) + static_cast<double>(start.time_since_epoch().count());
  if (type == std::type_index(typeid(int))) y += 1;
  if (failure) y += 2;
  if (path == "a") y += 4;
  if (word == "slow") y += 8;
  return y + single.real() + dice.max() + bell.mean();
}
} // namespace never

int main() { std::printf("%g %g\n", scaled(0.5), never::unchanged(0.5)); }
