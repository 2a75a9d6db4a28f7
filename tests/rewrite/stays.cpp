// What is needed as a constant, or counts in plain numbers, stays double.
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
#include <algorithm>
#include <chrono>
#include <random>

// CHECK: constexpr double scale = 2.5;
constexpr double scale = 2.5;
// CHECK: static_assert(sizeof(double) == 8, "");
static_assert(sizeof(double) == 8, "");
// CHECK: char buffer[sizeof(double) * 2]; int table[static_cast<int>(scale * 2.0)];
char buffer[sizeof(double) * 2]; int table[static_cast<int>(scale * 2.0)];
// CHECK: enum { size = sizeof(double) };
enum { size = sizeof(double) };
// CHECK: long double wide(long double x) { long double y = 2.0L * x; return y; }
long double wide(long double x) { long double y = 2.0L * x; return y; }
// CHECK: double long other(double long x) { return x; }
double long other(double long x) { return x; }
// CHECK: REAL noise(unsigned seed) {
double noise(unsigned seed) {
  std::mt19937 generator(seed);
  // CHECK: std::normal_distribution<double> normal(0.0, 1.0);
  std::normal_distribution<double> normal(0.0, 1.0);
  // CHECK: std::chrono::duration<double> elapsed(0.5);
  std::chrono::duration<double> elapsed(0.5);
  // CHECK: return std::max(REAL_C(normal(generator)), REAL_C(scale)) + REAL_LATER(elapsed.count());
  return std::max(normal(generator), scale) + elapsed.count();
}
// CHECK: REAL clip(REAL x) { return std::min(x, REAL_C(scale)); }
double clip(double x) { return std::min(x, scale); }
