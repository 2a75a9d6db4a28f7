/* Scalar code against vectors, bit by bit, any NaN equal to any NaN, at all combinations of corners. */
#include <math.h>
#include <stdio.h>
#include <string.h>

void compute(double const *input, double const *constants, double *output);
void vectors(double const *input, double const *constants, double *output);

int main(void) {
  double const corners[] = {0.0, -0.0, 1.0, -0.1, 1e300, 5e-324, INFINITY, -INFINITY, NAN, 0.3, 0x1.fffffffffffffp-1};
  enum { count = sizeof corners / sizeof *corners };
  int different = 0;
  for (int a = 0; a < count; ++a)
    for (int b = 0; b < count; ++b)
      for (int c = 0; c < count; ++c) {
        double input[12], x[4], y[4];
        for (int k = 0; k < 4; ++k) {
          input[k] = corners[(a + k) % count];
          input[k + 4] = corners[(b + 2 * k) % count];
          input[k + 8] = corners[(c + 3 * k) % count];
        }
        compute(input, input, x);
        vectors(input, input, y);
        for (int k = 0; k < 4; ++k) different += memcmp(x + k, y + k, sizeof *x) != 0 && !(isnan(x[k]) && isnan(y[k]));
      }
  if (different != 0) printf("%d differ\n", different);
  return different != 0;
}
