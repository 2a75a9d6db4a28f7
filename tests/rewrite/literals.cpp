// Literals are wrapped where they decide a type, and only there.
// RUN: %rewrite %s | FileCheck %s
// RUN: %same %s
#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <utility>
#include <vector>

// CHECK: REAL plain(REAL x) { return 2.0 * x + std::pow(x, 2.0) - std::sin(0.5) + 1.0; }
double plain(double x) { return 2.0 * x + std::pow(x, 2.0) - std::sin(0.5) + 1.0; }
// CHECK: REAL larger(REAL x) { return std::max(x, REAL_C(0.0)); }
double larger(double x) { return std::max(x, 0.0); }
// CHECK: return std::min({REAL_C(1.0), x, REAL_C(-2.0)});
double least(double x) { return std::min({1.0, x, -2.0}); }
// CHECK: REAL chosen(bool c, REAL x) { return c ? x : REAL_C(0.0); }
double chosen(bool c, double x) { return c ? x : 0.0; }
// CHECK: REAL both(bool c) { return c ? 1.0 : 0.0; }
double both(bool c) { return c ? 1.0 : 0.0; }
// CHECK: return std::accumulate(REAL_READ({{.*}}, v).begin(), REAL_READ({{.*}}, v).end(), REAL_C(0.0));
double sum(std::vector<double> const &v) { return std::accumulate(v.begin(), v.end(), 0.0); }
// CHECK: REAL loop(REAL x) { auto s = REAL_C(0.0); s += x; return s; }
double loop(double x) { auto s = 0.0; s += x; return s; }
// CHECK: std::vector<REAL> one{REAL_C(1.0)}; std::vector<REAL> many = {1.0, 2.0, 3.0};
std::vector<double> one{1.0}; std::vector<double> many = {1.0, 2.0, 3.0};
int g(long), g(double);
inline int g(long) { return 1; }
inline int g(double) { return 2; }
// CHECK: int overloaded() { return g(REAL_C(2.5)); }
int overloaded() { return g(2.5); }
struct W { W(double x) : value(x) {} double value; };
inline double take(W w) { return w.value; }
// CHECK: REAL converted() { W w = REAL_C(1.0); W direct(1.0); return take(REAL_C(2.0)) + w.value + direct.value; }
double converted() { W w = 1.0; W direct(1.0); return take(2.0) + w.value + direct.value; }
// CHECK: auto sign = [](REAL x) { if (x > 0) return REAL_C(1.0); return REAL_C(-1.0); };
auto sign = [](double x) { if (x > 0) return 1.0; return -1.0; };
// CHECK: std::complex<REAL> turn(std::complex<REAL> z) { return REAL_C(2.0) * z; }
std::complex<double> turn(std::complex<double> z) { return 2.0 * z; }
// CHECK: std::pair p(REAL_C(1.0), 2);
std::pair p(1.0, 2);
// CHECK: decltype(REAL_C(1.0)) d;
decltype(1.0) d;
