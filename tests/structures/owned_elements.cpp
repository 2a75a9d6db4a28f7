// A class that owns its numbers by a plain pointer and lets them be seen as a sequence, and one that derives from it.
// RUN: %symreal generate %s -o %t.c && FileCheck %s --input-file=%t.c
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// CHECK: input[2] + input[0]*input[1];
// SAME: e[0] {{ *}}1 {{ *}}0 {{ *}}0
#include <cstddef>
#include <cstdio>

class Vector {
  double *data_;
  std::size_t size_;

public:
  explicit Vector(std::size_t n) : data_(new double[n]()), size_(n) {}
  ~Vector() { delete[] data_; }
  double operator[](std::size_t i) const { return data_[i]; }
  double &operator[](std::size_t i) { return data_[i]; }
  std::size_t size() const { return size_; }
};
class Positions : public Vector {
public:
  explicit Positions(std::size_t n = 0) : Vector(n) {}
};

int main() {
  Vector q(2);
  Positions p(1), e(1);
#pragma symreal input(q, p)
  e[0] = q[0] * q[1] + p[0];
#pragma symreal output(e) generate("e.c")
  std::printf("%g\n", e[0]);
}
