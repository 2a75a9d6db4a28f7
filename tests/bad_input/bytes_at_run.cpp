// The bytes of a REAL looked at as something else, where only the run shows it. Bytes of ordinary numbers are harmless.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

#include <cstdint>
#include <cstdio>
#include <cstring>

union Bits {
  double number;
  uint64_t bits;
  struct {
    unsigned fraction_low : 32, fraction_high : 20, exponent : 11, sign : 1;
  } parts;
};

struct Value { // a tag says which one holds
  int is_number;
  union {
    double number;
    long whole;
  };
};

struct State {
  double v[2];
  int n;
};

uint64_t hash(void const *bytes) { return *(uint64_t const *)bytes; }

uint64_t watched(void const volatile *bytes) { return *(uint64_t const volatile *)bytes; }

uint64_t checksum(State const &state) {
  unsigned char const *bytes = (unsigned char const *)&state;
  uint64_t sum = 0;
  for (unsigned i = 0; i < sizeof state; i++) sum += bytes[i];
  return sum;
}

uint64_t look(double x) {
  Bits u;
  u.number = x;
  uint64_t sum = u.bits + u.parts.exponent;
  uint64_t copy;
  std::memcpy(&copy, &x, sizeof copy);
  char text[sizeof(double)];
  std::memcpy(text, &x, sizeof text);
  State const state = {{1.0, x}, 2};
  Value value;
  value.whole = 3;
  sum += value.whole;
  value.number = x;
  value.whole = 4; // overwritten, not read
  sum += value.whole;
  State const other = {{1.0, 2.0}, 2};
  sum += std::memcmp(&other, &state, sizeof state) == 0;
  std::FILE *file = std::tmpfile();
  sum += std::fwrite(&x, sizeof x, 1, file);
  std::rewind(file);
  double back = 0;
  sum += std::fread(&back, sizeof back, 1, file);
  std::fclose(file);
  sum += back == 3.0;
  return sum + copy + text[0] + hash(&x) + watched(&copy) + checksum(state);
}

int main() {
  double q = 0.5, y;
#pragma symreal input(q)
  uint64_t const harmless = look(3.0);
  uint64_t const harmful = look(2.0 * q);
  y = q + 1.0;
#pragma symreal output(y) generate("y.c")
  std::printf("%d\n", harmless == harmful);
}

// CHECK-DAG: bytes_at_run.cpp:44:18: error: the bytes behind 'u' are those of a symbolic value [SYM035]
// CHECK-DAG: bytes_at_run.cpp:44:27: error: the bytes behind 'u' are those of a symbolic value [SYM035]
// CHECK-DAG: bytes_at_run.cpp:46:3: error: the bytes behind '&x' are those of a symbolic value [SYM035]
// CHECK-DAG: bytes_at_run.cpp:48:3: error: the bytes behind '&x' are those of a symbolic value [SYM035]
// CHECK-DAG: bytes_at_run.cpp:57:10: error: the bytes behind '&other' or '&state' are those of a symbolic value [SYM035]
// CHECK-DAG: bytes_at_run.cpp:59:10: error: the bytes behind '&x' are those of a symbolic value [SYM035]
// CHECK-DAG: bytes_at_run.cpp:30:{{[0-9]+}}: error: the bytes behind 'bytes' are those of a symbolic value [SYM035]
// CHECK-DAG: bytes_at_run.cpp:35:{{[0-9]+}}: error: the bytes behind '&state' are those of a symbolic value [SYM035]
// CHECK-NOT: value.whole
