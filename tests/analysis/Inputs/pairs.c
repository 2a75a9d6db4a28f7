/* The sum of all products of two of N numbers; N comes from the compiler or as an argument. */
#include <stdlib.h>
#ifndef N
#define N 3
#endif
#pragma symreal function input(x[0:n]) output(return)
double pairs(int n, double const *x) {
  double sum = 0;
  for (int i = 0; i < n; i++)
    for (int j = 0; j < i; j++)
      sum += x[i] * x[j];
  return sum;
}
int main(int argc, char **argv) {
  double x[100];
  int n = argc > 1 ? atoi(argv[1]) : N;
  for (int i = 0; i < n; i++)
    x[i] = i + 0.5;
  return pairs(n, x) < 0;
}
