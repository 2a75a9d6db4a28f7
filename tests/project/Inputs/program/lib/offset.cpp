#include "parts.h"
#include "shift.h"

double offset(double x) {
#ifdef REFUSED
  x = __builtin_powi(x, 2);
#endif
#ifdef DECIDES
  if (x > SHIFT) return x;
#endif
  return x + SHIFT + FACTOR;
}
