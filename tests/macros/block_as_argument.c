/* The argument of a macro may be a block with macros in it. */
// RUN: %rewrite %s -- | FileCheck %s
// RUN: %same %s --
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// SAME: sum[0] {{ *}}2 {{ *}}0 {{ *}}0
// CHECK: #define LOOK_UP(i, at) do { at = REAL_READ("first[i]", {{.*}}, first[i]) + REAL_READ("rank[i]", {{.*}}, rank[i]); } while (0)
#define LOOK_UP(i, at) do { at = first[i] + rank[i]; } while (0)
// CHECK-NOT: "body"
#define WALK(n, body)             \
  {                               \
    for (int e = 0; e < n; e++) { \
      body                        \
    }                             \
  }
#include <stdio.h>
static void fill(int n, int const *first, int const *rank, double *sum)
{
    WALK(n, {
        int at;
        LOOK_UP(e, at);
        sum[at / 2] += 1.5 * sum[0];
    })
}

int main(void)
{
    double sum[2] = {1, 2};
    int const first[3] = {0, 1, 0}, rank[3] = {0, 0, 1};
#pragma symreal input(sum) constant(first, rank)
    fill(3, first, rank, sum);
#pragma symreal output(sum) generate("sum.c")
    printf("%g %g\n", sum[0], sum[1]);
    return 0;
}
