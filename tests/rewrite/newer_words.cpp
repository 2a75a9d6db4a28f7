// What C++20 took for words of its own and what it took out of its library: symbolic mode is C++20.
// RUN: %rewrite %s -- -std=c++17 | FileCheck %s
// RUN: %symreal verify --numeric %s -- -std=c++17 -O1
// RUN: %rewrite %s -- -std=c++17 > %t.rewritten.cpp && %rewrite %t.rewritten.cpp -- -std=c++17 | diff %t.rewritten.cpp -
// RUN: %symreal generate %s -o %t.c -- -std=c++17 && %symreal verify --samples=100 --min-samples=10 %s %t.c -- -std=c++17
#include <cstdio>
#include <memory>

// CHECK: static int REAL_NAME(concept)(int REAL_NAME(requires)) { return REAL_NAME(requires) + 1; }
static int concept(int requires) { return requires + 1; }
struct Point {
  double x, y;
};
// As a library's template does it, which is not rewritten.
template <class T, class Allocator = std::allocator<T>> struct Storage {
  typename Allocator::pointer data;
  Allocator allocator;
  explicit Storage(T const &value) : data(allocator.allocate(1)) { allocator.construct(data, value); }
  ~Storage() {
    allocator.destroy(data);
    allocator.deallocate(data, 1);
  }
};

int main() {
  double x = 1.5, y;
#pragma symreal input(x)
  std::allocator<Point> points;
  Point *const p = points.allocate(1);
  // CHECK: REAL_EITHER((points.construct), ::std::construct_at)(p, Point{x, 2});
  points.construct(p, Point{x, 2});
  Storage<double> const storage(x);
  Storage<unsigned long> const index(1);
  y = p->x * p->y + concept(2) + *storage.data * static_cast<double>(*index.data);
  // CHECK: REAL_EITHER((points.destroy), ::std::destroy_at)(p);
  points.destroy(p);
  points.deallocate(p, 1);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
