#include "lib.h"

int main() {
  root(1.5);
  powers(1.5);
  series(1.5);
  pose(1.5);
  hidden(1.5);
  both(1.5);
}
