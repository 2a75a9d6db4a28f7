// Pragmas in a block: all on their own line, in order.
// RUN: cd %S && %symreal rewrite --out-root %t pragma_region.cpp && grep -v CHECK: %t/pragma_region.cpp | FileCheck pragma_region.cpp
// RUN: %same %s
#include <vector>
#define N 2

double run(double const *p, std::vector<double> &v, int n) {
  double c[3][3], q = 1.0;
  // CHECK: {{^}}SYMREAL_OBJECT(input, "q", "pragma_region.cpp", [[@LINE+1]], 23, q) SYMREAL_AROUND("n", "pragma_region.cpp:7:57", n) SYMREAL_LEADS(p) SYMREAL_LEADS(__builtin_addressof(v)) SYMREAL_RANGE(-1.5, 1.5){{$}}
#pragma symreal input(q) range(-1.5, 1.5)
  // CHECK: SYMREAL_REBIND(p, 1, n + N) SYMREAL_SECTION(parameter, "p[1:n + N]", "pragma_region.cpp", [[@LINE+1]], 31, ::symreal::symreal_extents(n + N), p[(1)+symreal_i[0]]){{$}}
  #pragma symreal parameter(  p[1:n  +  N] )
  // CHECK: SYMREAL_DECLARE(constant, "v", {{.*}}, v) //
#pragma symreal constant(v) // a comment stays away
  c[0][0] = q * p[1] + v[0];
  // CHECK: SYMREAL_SECTION(output, "c[0:N][:3]", {{.*}}, ::symreal::symreal_extents(N, 3), c[SYMREAL_INDEX(3, "c", (0)+symreal_i[0])][(0)+symreal_i[1]]) SYMREAL_OBJECT(output, "c[2][0]", {{.*}}, c[2][0])
  // CHECK-EMPTY:
  // CHECK-NEXT: SYMREAL_GENERATE("step.c", "pragma_region.cpp", [[@LINE+3]], 17)
#pragma symreal output(c[0:N][:3], \
                       c[2][0])
#pragma symreal generate("step.c")
  return c[0][0];
}
