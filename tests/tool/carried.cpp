// A result with a time stamp in whole microseconds: no output depends on it, and a pragma says so.
// RUN: %same %s
// RUN: %symreal generate %s -o %t.c 2>&1 | FileCheck %s && FileCheck %s --check-prefix=CODE < %t.c
// RUN: %symreal verify %s %t.c --samples=100
// Where the word is wrong, verification tells.
// RUN: %symreal generate %s -o %t_wrong.c -- -DWRONG
// RUN: python3 %tools/expect_status.py 3 %symreal verify %s %t_wrong.c --samples=100 -- -DWRONG
#include <cmath>
#include <cstdint>
#include <cstdio>

struct Time {
  explicit Time(std::int64_t microseconds) : microseconds(microseconds) {}
  std::int64_t microseconds;
};

struct Sample {
  std::int64_t microseconds;
  double position;
};

#pragma symreal function decisions(carry)
std::int64_t stamp(double seconds) {
  // CHECK: carried.cpp:[[@LINE+1]]:{{[0-9]+}}: warning: a pragma says that no output depends on the conversion of {{.*}} [SYM118]
  return static_cast<std::int64_t>(seconds * 1e6);
}

// The pragma makes no kernel of a function that returns an object, made first or not.
#pragma symreal function decisions(carry)
Time time(double seconds) { return Time(stamp(seconds)); }

#pragma symreal function decisions(carry)
Sample at(double t) {
  double const position = std::sin(t) + t;
  return {time(t).microseconds, position};
}

// CODE: void compute(
#pragma symreal function input(t) range(0, 100) output(return)
double position(double t) {
  Sample const sample = at(t);
#ifdef WRONG
  return sample.position + static_cast<double>(sample.microseconds);
#else
  return sample.position;
#endif
}

int main() { std::printf("%g\n", position(1.5)); }
