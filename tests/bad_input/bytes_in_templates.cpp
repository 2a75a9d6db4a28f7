// The bytes of a REAL looked at in a template or a generic lambda: reported there, with the instantiation.
// RUN: not %symreal generate %s -o %t.c -- -std=c++20 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <span>
#include <string_view>
#include <unistd.h>

struct Words {
  uint32_t low, high;
};

// CHECK-DAG: bytes_in_templates.cpp:[[@LINE+2]]:{{[0-9]+}}: error: the bytes of a REAL are looked at as const unsigned long * [SYM035]
// CHECK-DAG: bytes_in_templates.cpp:[[@LINE+2]]:{{[0-9]+}}: note: in the instantiation pun<unsigned long, double>
template <class To, class From> To pun(From const &f) { return *reinterpret_cast<To const *>(&f); }
template <class T> uint64_t exponent(T v) { return pun<uint64_t>(v) >> 52; }
// CHECK-DAG: bytes_in_templates.cpp:[[@LINE+2]]:{{[0-9]+}}: error: the bytes of a REAL are looked at as const unsigned char * [SYM035]
template <class T> uint64_t sum(T const &v) {
  auto const *bytes = reinterpret_cast<unsigned char const *>(&v);
  return bytes[0] + 2u * bytes[7];
}
template <class T> std::size_t hashed(T const &v) {
  // CHECK-DAG: bytes_in_templates.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of a REAL are looked at as const char * [SYM035]
  return std::hash<std::string_view>()(std::string_view(reinterpret_cast<char const *>(&v), sizeof v));
}
// CHECK-DAG: bytes_in_templates.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of a REAL are looked at as const std::byte * [SYM035]
template <class T> int top(T const &v) { return (int)(reinterpret_cast<std::byte const *>(&v)[7]); }
// CHECK-DAG: bytes_in_templates.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of a REAL are looked at as const Words * [SYM035]
template <class T> unsigned high(T const &v) { return reinterpret_cast<Words const *>(&v)->high; }
// CHECK-DAG: bytes_in_templates.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of a REAL are used as another type [SYM035]
template <class T> int last(T x) { return int(std::as_bytes(std::span(&x, 1))[7]); }
// CHECK-DAG: bytes_in_templates.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of a REAL are used as another type [SYM035]
template <class T> uint64_t cast(T x) { return std::bit_cast<uint64_t>(x); }
// CHECK-DAG: bytes_in_templates.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of a REAL go to 'write', which is outside the roots [SYM035]
template <class T> void keep(T const &x, int file) { (void)!write(file, &x, sizeof x); }
struct Pair {
  double a, b;
};
// CHECK-DAG: bytes_in_templates.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of an object that holds REALs are compared [SYM035]
bool swap_in(std::atomic<Pair> &p, Pair &old, Pair now) { return p.compare_exchange_strong(old, now); }
// CHECK-DAG: bytes_in_templates.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of a REAL are compared [SYM035]
bool swap_raw(double *p, double *old, double *now) { return __atomic_compare_exchange(p, old, now, false, 5, 5); }

int main() {
  double x = 1.5, y;
#pragma symreal input(x)
  // CHECK-DAG: bytes_in_templates.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of a REAL are used as another type [SYM035]
  auto const bits = [](auto v) { return std::bit_cast<uint64_t>(v); };
  y = x + exponent(x) + sum(x) + hashed(x) + top(x) + high(x) + last(x) + cast(x) + bits(x);
  keep(x, 1);
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
