// A library that was compiled as it is. Each function does one thing to numbers.
#include <math.h>

int plain_less(double const *a, double const *b) { return *a < *b; }
int plain_truncate(double const *a) { return (int)*a; }
long plain_round(double const *a) { return (long)((long double)*a + 0.5L); }
void plain_larger(double const *a, double *result) { *result = *a > 1 ? *a : 1; }
void plain_distance(double const *a, double *result) { *result = fabs(*a) + 1; }
void plain_root(double const *a, double *result) { *result = sqrt(*a); }
void plain_float(double const *a, double *result) { *result = (float)*a; }
void plain_sum(double const *a, double *result) {
  double sum = 0;
  for (int i = 0; i < 2; i++)
    sum += a[i];
  *result = sum;
}
