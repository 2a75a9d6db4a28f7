#include "gain.h"
#include <factor.h>
#if __has_include("optional.h")
#include "optional.h"
#else
#define FACTOR_IN_TURN FACTOR
#endif
double gain(int n) { return n * FACTOR_IN_TURN; }
