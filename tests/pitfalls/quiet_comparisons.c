/* The comparisons that raise no exception are decisions like others. */
// RUN: %symreal generate %s -o %t.c --decisions=select && FileCheck %s --input-file=%t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c
// RUN: %if all %{ cp %s %t.cpp && %symreal generate %t.cpp -o %t2.c --decisions=select && %symreal verify --samples=100 --min-samples=10 %t.cpp %t2.c %}
// RUN: %symreal generate %s -o %t.strict.c --decisions=select --fp=strict && %symreal verify --samples=100 --min-samples=10 %s %t.strict.c
// CHECK: input[0] > t0 ? input[0] : t0;
// CHECK: 2.0 < input[2] ? t0 : -input[2];
// CHECK: (input[0] < input[2]) || (input[0] > input[2]) ? t0 : input[0];
// CHECK: output[5] = t0;
#include <math.h>
#include <stdio.h>
#ifdef __cplusplus
using std::isgreater; using std::isgreaterequal; using std::isless; using std::islessequal; using std::islessgreater; using std::isunordered;
#endif

#pragma symreal function input(x[0:3]) output(y[0:6])
void kernel(double const *x, double *y)
{
    y[0] = isgreater(x[0], x[1]) ? x[0] : x[1];
    y[1] = isgreaterequal(x[0], 1.5) ? x[0] : x[2];
    y[2] = isless(2, x[2]) ? x[1] : -x[2];
    y[3] = islessequal(x[1], 0.5) ? x[0] : x[2];
    y[4] = islessgreater(x[0], x[2]) ? x[1] : x[0];
    y[5] = isunordered(x[0], x[1]) ? x[2] : x[1];
}

int main(void)
{
    double x[3] = {1.5, 2.5, 0.25}, y[6];
    kernel(x, y);
    printf("%g\n", y[0]);
    return 0;
}
