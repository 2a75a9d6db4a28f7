#include <stdlib.h>
double *buffer(int n) { double *data = malloc(n * sizeof(double)); return data; }
