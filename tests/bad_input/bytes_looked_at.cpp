// The bytes of a REAL looked at as something else, outside of a kernel, of a constant in it, and of a symbolic value.
// RUN: not %symreal generate %s -o %t.none.c -- -std=c++20 2>&1 | FileCheck %s
// RUN: not ls %t.none.c
// RUN: %symreal generate %s -o %t.c -- -std=c++20 -DHARMLESS && %symreal verify --samples=100 --min-samples=10 %s %t.c -- -std=c++20 -DHARMLESS 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <unistd.h>

struct Words {
  uint32_t low, high;
};

// CHECK-DAG: bytes_looked_at.cpp:[[@LINE+1]]:53: error: the bytes behind '&x' are those of a symbolic value [SYM035]
uint64_t by_pointer(double x) { return *(uint64_t *)&x; }
// CHECK-DAG: bytes_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind 'x' are those of a symbolic value
uint64_t by_bit_cast(double x) { return std::bit_cast<uint64_t>(x); }
// CHECK-DAG: bytes_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind 'x' are those of a symbolic value
uint64_t by_builtin(double x) { return __builtin_bit_cast(uint64_t, x); }
// CHECK-DAG: bytes_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind 'x' are those of a symbolic value
uint64_t by_reference(double x) { return reinterpret_cast<uint64_t &>(x); }
// CHECK-DAG: bytes_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind '&x' are those of a symbolic value
unsigned by_structure(double x) { return reinterpret_cast<Words *>(&x)->high; }
// CHECK-DAG: bytes_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind '&x' are those of a symbolic value
void written(double x, int file) { (void)!write(file, &x, sizeof x); }
// CHECK-DAG: bytes_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind '&x' are those of a symbolic value
void streamed(double x, std::ostream &out) { out.write(reinterpret_cast<char const *>(&x), sizeof x); }

unsigned sum(unsigned char const *bytes, std::size_t count) {
  unsigned result = 0;
  for (std::size_t i = 0; i < count; ++i) result += bytes[i];
  return result;
}

// Not the first number is symbolic.
// CHECK-DAG: bytes_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind 'x' are those of a symbolic value
unsigned of_array(double const *x) { return sum((unsigned char const *)x, 2 * sizeof *x); }

// The number is symbolic after the pointer was made.
unsigned by_variable(double x) {
  double copy = 0;
  auto *bytes = (unsigned char *)&copy;
  bytes[0] = 1; // no read
  copy = x;
  // CHECK-DAG: bytes_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind 'bytes[7]' are those of a symbolic value
  unsigned result = bytes[7];
  unsigned char *next = bytes + 1;
  // CHECK-DAG: bytes_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind '*next' are those of a symbolic value
  result += *next;
  // CHECK-DAG: bytes_looked_at.cpp:[[@LINE+2]]:{{[0-9]+}}: error: the bytes behind 'bytes' are those of a symbolic value
#ifndef HARMLESS
  result += sum(bytes, sizeof copy);
#endif
  return result;
}

// As a program swaps the bytes of a number that it has read.
double swapped(double x) {
  unsigned char *bytes = (unsigned char *)&x, other[sizeof x];
  for (std::size_t i = 0; i < sizeof x; ++i) other[i] = bytes[sizeof x - 1 - i];
  std::memcpy(&x, other, sizeof x);
  return x;
}

uint64_t look(double x) {
  std::stringstream text;
  streamed(x, text);
  written(x, -1);
  double *const both = new double[2]{1.0, x};
  unsigned const all = of_array(both);
  delete[] both;
  return by_pointer(x) + by_bit_cast(x) + by_builtin(x) + by_reference(x) + by_structure(x) + all +
         by_variable(x);
}

int main() {
  double q = 0.5, y;
  double const factor = swapped(swapped(2.5)) + static_cast<double>(look(3.0) % 2);
#pragma symreal input(q)
  y = q * factor + static_cast<double>(look(4.0) % 8);
#ifndef HARMLESS
  y += static_cast<double>(look(2.0 * q) % 2);
#endif
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
