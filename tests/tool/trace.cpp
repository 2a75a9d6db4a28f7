// Generated statements carry the source's names, and on request say where they come from: as comments, as a map, and
// when a value is no longer finite.
// RUN: %symreal generate %s -o %t.c --debug=comments --map %t.json --mainline 2>/dev/null
// RUN: FileCheck %s --input-file=%t.c
// RUN: FileCheck %s --input-file=%t.json --check-prefix=MAP
// RUN: %cc -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror -O1 -ffp-contract=off %t.c %t_main.c -lm -o %t.run
// RUN: %t.run | FileCheck %s --check-prefix=VALUE
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c
// The text of the graph carries names and places, so the same code comes from it, but for the line of the original's library.
// RUN: %symreal generate %s -o %t.c --graph %t.graph 2>/dev/null
// RUN: %symreal opt %t.graph --lang=c -o %t.again.c && grep -vE "include|functions of the original" %t.c > %t.1 && grep -v include %t.again.c | diff %t.1 -
// RUN: %symreal generate %s -o %t.debug.c --debug=values --mainline 2>/dev/null
// RUN: %cc -std=c99 -Wall -Wextra -Wconversion -pedantic -Werror -O1 %t.debug.c %t.debug_main.c -lm -o %t.debug
// RUN: %t.debug 2>&1 | FileCheck %s --check-prefix=FINE
// RUN: %t.debug 0 0 2>&1 | FileCheck %s --check-prefix=BROKEN

#include <cmath>

static inline double square(double t1) { return t1 * t1; }

#pragma symreal function input(x, y) output(return, sin[0:1])
double kernel(double x, double y, double *sin) {
  double const range = std::sqrt(square(x) + square(y));
  double angle;
  angle = std::atan2(y, x) + 2 * range;
  double const inputs = y / range;
  *sin = inputs * inputs + range;
  angle += inputs * angle;
  return angle * angle * range;
}

int main() {
  double sin;
  return kernel(1.5, 0.5, &sin) > 0 ? 0 : 1;
}

// CHECK: double const range = sqrt({{.*}}); /* trace.cpp:19, trace.cpp:23 */
// CHECK-NEXT: double const angle = {{.*}}; /* trace.cpp:25 */
// CHECK-NEXT: double const inputs = input[1]/range; /* trace.cpp:26 */
// CHECK-NEXT: double const sin_ = range + inputs*inputs; /* trace.cpp:27 */
// CHECK-NEXT: double const angle_2 = angle + angle*inputs; /* trace.cpp:28 */
// MAP: "first": [[#]],
// MAP-NEXT: "last":
// MAP: "file": "{{.*}}trace.cpp",
// MAP-NEXT: "line":
// VALUE: value_return = 33.25
// FINE-NOT: not finite
// BROKEN: not finite: inputs = div at trace.cpp:26 is {{-?}}nan
// BROKEN-NOT: not finite
