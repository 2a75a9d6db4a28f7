#include "matrix.h"
#include "shared.h"
struct Inner {
  double mass = 2;
};
Inner kept_elsewhere;
Outer::Outer() : inner(new Inner) {}
Outer::~Outer() = default;
double known(double x) {
  static Outer outer;
  Outer *used = &outer;
  return x * used->inner->mass;
}
