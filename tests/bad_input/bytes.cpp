// The bytes of a REAL looked at as something else, where the source shows it.
// RUN: not %symreal generate %s -o %t.c -- -std=c++20 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ostream>
#include <unistd.h>

struct State {
  double v[3];
  int n;
};

// CHECK: bytes.cpp:[[@LINE+1]]:41: error: the bytes of a REAL are looked at as uint64_t *
uint64_t by_pointer(double x) { return *(uint64_t *)&x; }
// CHECK: bytes.cpp:[[@LINE+1]]:41: error: the bytes of a REAL are used as another type
uint64_t by_bit_cast(double x) { return std::bit_cast<uint64_t>(x); }
// CHECK: bytes.cpp:[[@LINE+1]]:40: error: the bytes of a REAL are used as another type
uint64_t by_builtin(double x) { return __builtin_bit_cast(uint64_t, x); }
// CHECK: bytes.cpp:[[@LINE+1]]:42: error: the bytes of a REAL are looked at as uint64_t [
uint64_t by_reference(double x) { return reinterpret_cast<uint64_t &>(x); }
// CHECK: bytes.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of a REAL go to 'write'
void written(double x, int file) { (void)!write(file, &x, sizeof x); }
// CHECK: bytes.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of a REAL are looked at as const char *
void streamed(double x, std::ostream &out) { out.write(reinterpret_cast<char const *>(&x), sizeof x); }

int main() {}
