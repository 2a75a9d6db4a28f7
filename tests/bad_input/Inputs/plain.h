// A header outside the roots that looks at the bytes of numbers.
#include <string.h>

static double plain_load(void const *number) {
  double value;
  memcpy(&value, number, sizeof value);
  return value;
}

static int plain_is_positive(void const *a) { return plain_load(a) > 0; }
