#include "lib/model.h"

int main() {
  double x[2] = {0.3, 0.4}, y;
#pragma symreal input(x)
  y = force(x[0], x[1]);
#pragma symreal output(y) generate("force.c")
}
