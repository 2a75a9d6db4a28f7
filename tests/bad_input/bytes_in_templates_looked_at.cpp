// The bytes of a symbolic value looked at in a template or a generic lambda.
// RUN: not %symreal generate %s -o %t.none.c -- -std=c++20 2>&1 | FileCheck %s
// RUN: not ls %t.none.c
// RUN: %symreal generate %s -o %t.c -- -std=c++20 -DHARMLESS && %symreal verify --samples=100 --min-samples=10 %s %t.c -- -std=c++20 -DHARMLESS 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: y {{ *}}1 {{ *}}0 {{ *}}0
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string_view>
#include <unistd.h>

struct Words {
  uint32_t low, high;
};

// CHECK-DAG: bytes_in_templates_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind '&f' are those of a symbolic value [SYM035]
template <class To, class From> To pun(From const &f) { return *reinterpret_cast<To const *>(&f); }
template <class T> uint64_t exponent(T v) { return pun<uint64_t>(v) >> 52; }
template <class T> uint64_t sum(T const &v) {
  // CHECK-DAG: bytes_in_templates_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind '&v' are those of a symbolic value
  auto const *bytes = reinterpret_cast<unsigned char const *>(&v);
  return bytes[0] + 2u * bytes[7];
}
template <class T> std::size_t hashed(T const &v) {
  // CHECK-DAG: bytes_in_templates_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind '&v' are those of a symbolic value
  return std::hash<std::string_view>()(std::string_view(reinterpret_cast<char const *>(&v), sizeof v));
}
// CHECK-DAG: bytes_in_templates_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind '&v' are those of a symbolic value
template <class T> int top(T const &v) { return (int)(reinterpret_cast<std::byte const *>(&v)[7]); }
// CHECK-DAG: bytes_in_templates_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind '&v' are those of a symbolic value
template <class T> unsigned high(T const &v) { return reinterpret_cast<Words const *>(&v)->high; }
// CHECK-DAG: bytes_in_templates_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind 'x' are those of a symbolic value
template <class T> uint64_t cast(T x) { return std::bit_cast<uint64_t>(x); }
// CHECK-DAG: bytes_in_templates_looked_at.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind '&x' are those of a symbolic value
template <class T> void keep(T const &x, int file) { (void)!write(file, &x, sizeof x); }

template <class T> uint64_t look(T x) {
  keep(x, -1);
  return exponent(x) + sum(x) + hashed(x) + top(x) + high(x) + cast(x);
}

int main() {
  double x = 1.5, y;
#pragma symreal input(x)
  y = x + look(0.5) % 8;
#ifndef HARMLESS
  y += look(2 * x);
#endif
#pragma symreal output(y) generate("y.c")
  std::printf("%g\n", y);
}
