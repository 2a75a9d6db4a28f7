// Whoever catches what is thrown, or takes out what a std::any keeps, names its type: a comparison and an integer made of a
// number have that of the original there.
// RUN: %same %s -- -std=c++20
// RUN: %rewrite %s -- -std=c++20 | FileCheck %s
// RUN: %symreal generate %s -o %t.c --decisions=guard -- -std=c++20 && %symreal verify %s %t.c --min-samples=20 --samples=100 -- -std=c++20
#include <any>
#include <cstdio>
#include <exception>

template <class T> double thrown(T value) {
  try {
    // CHECK: throw REAL_ERASED(value);
    throw value;
  } catch (bool b) {
    return b ? 1 : 2;
  } catch (int i) {
    return i;
  } catch (double d) {
    return d;
  } catch (...) {
    return -1;
  }
}
static bool is_truth(std::any const &kept) { return std::any_cast<bool>(&kept) != nullptr; }

#pragma symreal function input(x) range(0.2, 0.9) input(y) range(1.25, 1.45) output(return)
double kernel(double x, double y) {
  double result = thrown(x < y) + thrown(x * 2) + thrown(3);
  try {
    // CHECK: throw REAL_ERASED(x < y);
    throw x < y;
  } catch (bool b) {
    result += b ? x : y;
  } catch (...) {
    result = 0;
  }
  int const count = static_cast<int>(y * 4);
  try {
    // CHECK: throw REAL_ERASED(count + 1);
    throw count + 1;
  } catch (int i) {
    result += i * x;
  } catch (...) {
    result = 0;
  }
  // CHECK: std::any kept = REAL_ERASED(x > 1);
  std::any kept = x > 1;
  result += is_truth(kept) ? x : 7;
  // CHECK: kept = REAL_ERASED(!x);
  kept = !x;
  result += is_truth(kept) ? y : 8;
  kept = x;
  result += is_truth(kept) ? 9 : 1;
  try {
    // CHECK: std::make_exception_ptr(REAL_ERASED(x < 3))
    std::rethrow_exception(std::make_exception_ptr(x < 3));
  } catch (bool) {
    result *= 2;
  } catch (...) {
  }
  struct {
    int small : 3;
  } const bits{static_cast<int>(is_truth(kept)) + 1};
  try {
    // CHECK: throw REAL_ERASED(bits.small);
    throw bits.small;
  } catch (int i) {
    result += i;
  }
  // CHECK: throw 5;
  try { throw 5; } catch (int) { ++result; }
  return result;
}

int main() { std::printf("%g\n", kernel(0.7, 1.3)); }
