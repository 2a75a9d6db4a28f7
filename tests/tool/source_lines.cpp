// --stats counts operations by the line of the program that they come from, inlined functions included.
// RUN: %symreal generate %s -o %t.c --stats 2>&1 | FileCheck %s
// RUN: %symreal generate %s -o %t.c --stats --json 2>/dev/null | FileCheck %s --check-prefix=JSON

#include <cmath>

static inline double square(double x) { return x * x; }

#pragma symreal function input(a[0:3]) output(norm[0:1])
void length(double const *a, double *norm) {
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    sum += square(a[i]);
  *norm = std::sqrt(sum);
}

int main() {
  double a[3] = {1, 2, 3}, norm;
  length(a, &norm);
  return norm > 0 ? 0 : 1;
}

// CHECK: operations by source line (recorded, generated)
// CHECK-NEXT: 3 3 {{.*}}source_lines.cpp:7{{$}}
// CHECK-NEXT: 3 2 {{.*}}source_lines.cpp:13{{$}}
// CHECK-NEXT: 1 1 {{.*}}source_lines.cpp:14{{$}}
// JSON: "lines": [
// JSON-NEXT: {
// JSON-NEXT: "file": "{{.*}}source_lines.cpp",
// JSON-NEXT: "line": 7,
// JSON-NEXT: "recorded": 3,
// JSON-NEXT: "generated": 3
