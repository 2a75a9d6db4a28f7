#include <stdio.h>
#include <stdlib.h>

void p_counted(double const *parameters, double *constants);
static int calls;
static void tell(void) { fprintf(stderr, "preprocess ran %d times\n", calls); }

void p_preprocess(double const *parameters, double *constants) {
  if (calls++ == 0) atexit(tell);
  p_counted(parameters, constants);
}
