#include <model/spring.h>
double spring(double stiffness, double length) { return stiffness * twice(length); }
