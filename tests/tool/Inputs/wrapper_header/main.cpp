#include "gain.h"
#include <loss.h>

#include <cstdio>
#include <initializer_list>

double other(double x);

int main() {
  for (double x : {1.5, 0.25}) std::printf("%g %g %g\n", gain(x, 3), other(x), loss(x));
}
