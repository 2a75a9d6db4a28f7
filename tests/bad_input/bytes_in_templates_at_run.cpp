// The bytes of a REAL copied or compared in a template: harmless with ordinary numbers, else reported in the run.
// RUN: not %symreal generate %s -o %t.c -- -std=c++20 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <cstdint>
#include <cstdio>
#include <cstring>

struct Words {
  uint32_t low, high;
};

template <class T> bool is_nan(T v) {
  uint64_t u;
  // CHECK-DAG: bytes_in_templates_at_run.cpp:[[@LINE+1]]:3: error: the bytes behind '&v' are those of a symbolic value [SYM035]
  std::memcpy(&u, &v, sizeof u);
  return (u & 0x7fffffffffffffff) > 0x7ff0000000000000;
}
template <class T> unsigned high(T v) {
  Words words;
  // CHECK-DAG: bytes_in_templates_at_run.cpp:[[@LINE+1]]:3: error: the bytes behind '&v' are those of a symbolic value [SYM035]
  memcpy(&words, &v, sizeof words);
  return words.high;
}
template <class T> bool same(T const &a, T const &b) {
  // CHECK-DAG: bytes_in_templates_at_run.cpp:[[@LINE+1]]:10: error: the bytes behind '&a' or '&b' are those of a symbolic value [SYM035]
  return std::memcmp(&a, &b, sizeof a) == 0;
}
template <class T> struct Vector {
  T m[2];
  // CHECK-DAG: bytes_in_templates_at_run.cpp:[[@LINE+1]]:51: error: the bytes behind 'm' or 'o.m' are those of a symbolic value [SYM035]
  bool operator==(Vector const &o) const { return std::memcmp(m, o.m, sizeof m) == 0; }
};
template <class T> int sign(T x) {
  union {
    T number;
    uint64_t bits;
  } u;
  u.number = x;
  // CHECK-DAG: bytes_in_templates_at_run.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes behind 'u' are those of a symbolic value [SYM035]
  return static_cast<int>(u.bits >> 63);
}
template <class T> T copied(T const &x) {
  T y;
  memcpy(&y, &x, sizeof y);
  return y;
}

int look(double x) {
  return is_nan(x) + same(x, 2.0 * x) + (Vector<double>{x, x} == Vector<double>{1.0, x}) + sign(x) + (int)high(x) +
         (copied(7) > 3);
}

int main() {
  double x = 1.5, y;
#pragma symreal input(x)
  int const harmless = look(3.0);
  int const harmful = look(x);
  y = copied(x) + 1.0;
#pragma symreal output(y) generate("y.c")
  std::printf("%d %d %g\n", harmless, harmful, y);
}
