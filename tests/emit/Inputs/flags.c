/* Runs the kernel on its arguments; prints the outputs and which floating-point exceptions were raised. */
#include KERNEL
#include <fenv.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv) {
  double input[8] = {0}, output[8] = {0}, constants[8] = {0};
  int i;
  for (i = 1; i < argc && i <= 8; ++i) input[i - 1] = strtod(argv[i], NULL);
  feclearexcept(FE_ALL_EXCEPT);
  compute(input, constants, output);
  printf("raised%s%s%s:", fetestexcept(FE_INVALID) ? " invalid" : "", fetestexcept(FE_DIVBYZERO) ? " division" : "",
         fetestexcept(FE_OVERFLOW) ? " overflow" : "");
  for (i = 0; i < output_count; ++i) printf(" %.6g", output[i]);
  printf("\n");
  return 0;
}
