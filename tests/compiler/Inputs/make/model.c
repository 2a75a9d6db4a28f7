#include "step.h"

#include <stdio.h>

int main(void) {
  double x[2] = {0.5, 0};
  int i;
  for (i = 0; i < 10; i++) step(x, 0.01);
  printf("%.17g %.17g\n", x[0], x[1]);
  return 0;
}
