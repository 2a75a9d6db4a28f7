#include "model.h"

static double const values[] = {2.5, -0.5};
double const *const gains = values;
