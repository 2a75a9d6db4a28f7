#include "../include/body.h"
#include <stdlib.h>
double spin_of(double rate) { return rate * weight(rate); }
double *table(void) { return malloc(8 * sizeof(double)); }
