// Implicit conversions of a REAL are made visible; explicit ones are visible already.
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
#include <cstdio>
#include <vector>
namespace n { typedef int number; void count(number); }

// CHECK: int whole(REAL x) { return REAL_TO(int, x); }
int whole(double x) { return x; }
// CHECK: bool known(REAL x) { bool b = REAL_TO(bool, x); return b; }
bool known(double x) { bool b = x; return b; }
// CHECK: float narrow(REAL x) { float f = REAL_TO(float, x * 2.0); return f; }
float narrow(double x) { float f = x * 2.0; return f; }
// CHECK: int cut(REAL x) { return (int)x + static_cast<int>(x); }
int cut(double x) { return (int)x + static_cast<int>(x); }
// CHECK: int branch(REAL x) { if (x) return 1; while (!x) return 2; return x && 1 ? 3 : 4; }
int branch(double x) { if (x) return 1; while (!x) return 2; return x && 1 ? 3 : 4; }
int const half = 2.5;
// CHECK: bool zero(REAL x) { return x == REAL_C(0.0L) || REAL_C(-0.5L) > x; }
bool zero(double x) { return x == 0.0L || -0.5L > x; }
// CHECK: void keep(std::vector<int> &list, REAL x) { {{.*}}.push_back(REAL_TO(int, x)); n::count(REAL_TO(int, x)); }
void keep(std::vector<int> &list, double x) { list.push_back(x); n::count(x); }
// CHECK: void show(REAL x, float y) { std::printf("%g %g %g %d\n", REAL_VALUE(x), y, 1.5, half); }
void show(double x, float y) { std::printf("%g %g %g %d\n", x, y, 1.5, half); }
// CHECK: void read(REAL *x) { if (std::scanf("%lf", REAL_TARGET({{.*}}, x)) != 1) REAL_WRITTEN({{.*}}, *x) = 0; }
void read(double *x) { if (std::scanf("%lf", x) != 1) *x = 0; }
enum Direction { backwards = -1, forwards = 1 };
enum class Side { left, right };
// CHECK: return REAL(d) * x + static_cast<REAL>(s) + REAL_TO(int, d) * x + (REAL)d;
double turn(Direction d, Side s, double x) { return double(d) * x + static_cast<double>(s) + d * x + (double)d; }
