#include <stdio.h>

double control(double position, double rate);

int main(void) {
  printf("%g\n", control(1, 2));
  return 0;
}
