// No blank stands behind a brace or before a parenthesis, and what is inserted there makes no word with its neighbour.
// RUN: %rewrite %s | FileCheck %s
// RUN: %symreal generate %s -o %t.c && %symreal verify --samples=100 --min-samples=10 %s %t.c
// RUN: %same %s
#include <cstdio>
// CHECK: {{SYMREAL_OUTPUTS_END REAL_WRITTEN\(}}
#pragma symreal function input(x[0:2]) output(y[0:1])
void kernel(double const *x, double *y){y[0]=x[0]*x[1];}
int main(){double x[2]={1.5,2.5},y[1];kernel(x,y);std::printf("%g\n",y[0]);}
