/* A compiler says of both operands of || that they end where the condition ends: the guards tell them apart. */
// RUN: %symreal generate %s -o %t.c --decisions=guard 2>&1 | FileCheck %s
// RUN: %symreal verify --samples=100 --min-samples=10 %s %t.c 2>&1 | FileCheck %s --check-prefix=SAME
// CHECK: guard 1 {{.*}}: height<-1E3 {{.*}}is false
// CHECK: guard 2 {{.*}}: elevation[1]<=0 is false
// SAME: value_return {{ *}}1 {{ *}}0 {{ *}}0
#include <stdio.h>

static int log_it(int *week)
{
    *week = 3;
    return *week;
}

#pragma symreal function input(height, elevation[0:2]) output(return)
double delay(double height, double const *elevation)
{
    int week;
    if (height<-1E3||elevation[1]<=0) return 0.0;
    log_it(&week);
    goto end;
end:
    return elevation[0] / elevation[1] + height;
}

int main(void)
{
    double elevation[2] = {0.5, 0.4};
    printf("%g\n", delay(50, elevation));
    return 0;
}
