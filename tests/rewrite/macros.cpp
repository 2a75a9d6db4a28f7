// Macro bodies are edited where they stand, once; arguments that a macro quotes are data.
// RUN: %rewrite %s 2> %t.err | FileCheck %s
// RUN: FileCheck --check-prefix=WARNING %s < %t.err
// RUN: %same %s
#include <cassert>
#include <cmath>
#include <algorithm>

// CHECK: #define VECTOR(name) REAL name[3]
#define VECTOR(name) double name[3]
// CHECK: #define NUMBER REAL
#define NUMBER double
#define HALF 0.5
#define SQUARE(x) ((x) * (x))
#define TEXT(x) #x
#define DECLARE(type, name) type name##_value
// CHECK: #define UNUSED double
#define UNUSED double
#define NAMED(type, name) type name = 0; char const *name##_type = #type
double level = 1.0;
// CHECK: REAL f(NUMBER x) {
double f(NUMBER x) {
  VECTOR(v) = {x, x, x};
  // CHECK: REAL_EITHER((assert((double)x > 1.0 && level > 0.0)), assert((REAL)x > 1.0 && {{.*}} > 0.0));
  assert((double)x > 1.0 && level > 0.0);
  // CHECK: char const *s = TEXT(double);
  char const *s = TEXT(double);
  // A macro that also pastes stands there once.
  // CHECK: NAMED(double, q);
  // WARNING: macros.cpp:[[@LINE+1]]:{{[0-9]+}}: warning: 'double' stays as it is
  NAMED(double, q);
  // CHECK: DECLARE(REAL, w) = std::max(x, REAL_C(HALF)) + SQUARE(REAL_READ("level", "{{.*}}", REAL_STATE(level, "{{.*}}")));
  DECLARE(double, w) = std::max(x, HALF) + SQUARE(level);
  return v[0] + w_value + s[0] + q + q_type[0] + std::min(M_PI, 1.0);
}
