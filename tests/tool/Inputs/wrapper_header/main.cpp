#include "gain.h"
#include <loss.h>

#include <cstdio>
#include <initializer_list>

double other(double x);

int main() {
  for (double x : {1.5, 0.25}) {
    double const three = gain(x, 3), lost = loss(x);
    std::printf("%g %g %g\n", three, other(x), lost);
  }
}
