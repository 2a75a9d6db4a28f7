#include "../scale.h"
#include "settings.h"
inline double shifted(double x) { return x + OFFSET; }
