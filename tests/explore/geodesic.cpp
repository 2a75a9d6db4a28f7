// Code in the style of geodesic libraries, of our own making: angles that are reduced by quadrant, arguments that are
// swapped and signs that are kept apart, series here and closed forms there, Newton's method within a bracket, a loop
// that ends early. Policies explore and auto take all of it, and verification agrees on every sample.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o %t/ --decisions=auto --explore=paths=400 > %t/auto 2>&1
// RUN: FileCheck %s < %t/auto
// RUN: %symreal verify --samples=100 --min-samples=10 %s reduce.c sine_cosine.c area.c distance.c latitude.c --branches > %t/verified 2>&1
// RUN: FileCheck %s --check-prefix=SAME < %t/verified
// CHECK-NOT: {{warning|error}}
// CHECK: kernel reduce:
// CHECK: explored 1 path, 0 selects between them; complete: no guards
// CHECK: kernel sine_cosine:
// CHECK: complete but for the guards of pragmas and conversions
// CHECK: guard 1 geodesic.cpp:[[#@LINE+62]]:25: the conversion of
// CHECK-NOT: guard 2
// CHECK: kernel area:
// CHECK: explored 1 path, 0 selects between them; complete: no guards
// CHECK: kernel distance:
// CHECK: explored 1 path,
// CHECK: guard 1 geodesic.cpp:[[#@LINE+174]]:{{[0-9]+}}: std::fabs(lat1) < std::fabs(lat2) (0 < fabs(lat2)) where one of several paths comes by
// CHECK-NOT: guard 2
// CHECK: kernel latitude:
// CHECK: explored 1 path,
// CHECK: guard 1 geodesic.cpp:[[#@LINE+100]]:7: !(std::fabs(tau) < 2e7) is false
// CHECK-NOT: guard 2
// SAME: kernel reduce, mode finite
// SAME: every path is recorded: no sample is left to a guard
// SAME: out[0] 3 0 0{{$}}
// SAME: kernel sine_cosine, mode finite
// SAME: never true: case 2
// SAME: out[0] 3 0 0{{$}}
// SAME: kernel area, mode finite
// SAME: branches of the original: 6 of 6 directions taken by some sample
// SAME: value_return 1 0 0{{$}}
// SAME: kernel distance, mode finite
// SAME: branches of the original: 28 of 28 directions taken by some sample
// SAME: out[0] 3 0 0{{$}}
// SAME: kernel latitude, mode finite
// SAME: never true: !(std::fabs(tau) < 2e7)
// SAME: out[0] 2 0 0{{$}}
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace {

double const degree = 3.14159265358979323846 / 180;
double const f = 1 / 298.25, e2 = f * (2 - f), e = std::sqrt(e2);

double sq(double x) { return x * x; }

// NaN out of range, as a mark that callers test.
double fixed_latitude(double x) { return std::fabs(x) > 90 ? std::numeric_limits<double>::quiet_NaN() : x; }

// To [-180, 180], a multiple of 360 with the sign of x.
double normalized(double x) {
  double y = std::remainder(x, 360.0);
  return std::fabs(y) == 180 ? std::copysign(180.0, x) : y;
}

// x - y, and what rounding has lost of it.
double difference(double x, double y, double &lost) {
  double d = std::remainder(-x, 360.0), t = std::remainder(y, 360.0);
  double s = d + t, up = s - t, vpp = s - up;
  up -= d;
  vpp -= t;
  lost = s != 0 ? 0 - (up + vpp) : s;
  if (s == 0 || std::fabs(s) == 180) s = std::copysign(s, lost == 0 ? y - x : -lost);
  return s;
}

// By quadrants, so that multiples of 90 are exact.
void sincosd(double x, double &sinx, double &cosx) {
  int q = 0;
  double r = std::remquo(x, 90.0, &q);
  r *= degree;
  double s = std::sin(r), c = std::cos(r);
  switch (unsigned(q) & 3u) {
  case 0: sinx = s; cosx = c; break;
  case 1: sinx = c; cosx = -s; break;
  case 2: sinx = -s; cosx = -c; break;
  default: sinx = -c; cosx = s; break;
  }
  if (sinx == 0) sinx = std::copysign(sinx, x);
}

// The quadrants without an integer: a chain of thresholds.
double atan2d(double y, double x) {
  int q = 0;
  if (std::fabs(y) > std::fabs(x)) {
    std::swap(x, y);
    q = 2;
  }
  if (std::signbit(x)) {
    x = -x;
    ++q;
  }
  double angle = std::atan2(y, x) / degree;
  switch (q) {
  case 1: angle = std::copysign(180.0, y) - angle; break;
  case 2: angle = 90 - angle; break;
  case 3: angle = -90 + angle; break;
  default: break;
  }
  return angle;
}

// atanh(e x)/e for an ellipsoid, its limit, or that of a prolate one.
double eatanhe(double x, double es) {
  return es > 0 ? es * std::atanh(es * x) : es < 0 ? -es * std::atan(es * x) : x;
}

double taupf(double tau) {
  double tau1 = std::hypot(1.0, tau), sig = std::sinh(eatanhe(tau / tau1, e));
  return std::hypot(1.0, sig) * tau - sig * tau1;
}

// Its inverse by Newton's method, which ends early.
double tauf(double taup) {
  double const tolerance = std::sqrt(std::numeric_limits<double>::epsilon()) / 10;
  double const stop = tolerance * std::fmax(1.0, std::fabs(taup));
  double tau = std::fabs(taup) > 70 ? taup * std::exp(eatanhe(1, e)) : taup / (1 - e2);
  if (!(std::fabs(tau) < 2e7)) return tau;
  for (int i = 0; i < 5; ++i) {
    double taupa = taupf(tau);
    double dtau = (taup - taupa) * (1 + (1 - e2) * sq(tau)) / ((1 - e2) * std::hypot(1.0, tau) * std::hypot(1.0, taupa));
    tau += dtau;
    if (!(std::fabs(dtau) >= stop)) break;
  }
  return tau;
}

// A root in a bracket: Newton's step, or the middle where it leaves the bracket; a bounded number of rounds.
double bracketed(double a, double b) {
  double low = 0, high = 2, x = 1;
  for (int round = 0; round < 3; ++round) {
    double v = x * x * x + a * x - b, dv = 3 * x * x + a;
    if (v > 0)
      high = x;
    else if (v < 0)
      low = x;
    else
      break;
    double next = x - v / dv;
    if (dv <= 0 || next <= low || next >= high) next = (low + high) / 2;
    x = next;
  }
  return x;
}

} // namespace

#pragma symreal function input(lon1) range(-700, 700) input(lon2) range(-700, 700) output(out[0:3])
void reduce(double lon1, double lon2, double *out) {
  double lost;
  double lon12 = difference(lon1, lon2, lost);
  int sign = std::signbit(lon12) ? -1 : 1;
  lon12 *= sign;
  lost *= sign;
  out[0] = normalized(lon1);
  out[1] = lon12;
  out[2] = (180 - lon12) - lost;
}

#pragma symreal function input(x) range(-500, 500) output(out[0:3])
void sine_cosine(double x, double *out) {
  sincosd(x, out[0], out[1]);
  out[2] = atan2d(out[0], out[1]);
}

#pragma symreal function input(x) range(-1, 1) input(k) range(-0.5, 0.5) output(return)
double area(double x, double k) {
  double t = x * x * k;
  if (std::fabs(t) < 1e-2) { // a series
    double sum = 0, term = 1;
    for (int n = 0; n < 6; ++n) {
      sum += term / (2 * n + 1);
      term *= t;
    }
    return x * sum;
  }
  if (k > 0) return std::atanh(std::sqrt(k) * x) / std::sqrt(k);
  return std::atan(std::sqrt(-k) * x) / std::sqrt(-k);
}

#pragma symreal function input(lat1) range(-95, 95) input(lat2) range(-90, 90) input(lon12) range(-180, 180) output(out[0:3])
void distance(double lat1, double lat2, double lon12, double *out) {
  lat1 = fixed_latitude(lat1);
  if (std::isnan(lat1)) lat1 = 0;
  // Make lon12 >= 0, |lat1| >= |lat2| and lat1 <= 0.
  int lonsign = lon12 >= 0 ? 1 : -1;
  lon12 *= lonsign;
  int swapp = std::fabs(lat1) < std::fabs(lat2) ? -1 : 1;
  if (swapp < 0) {
    lonsign *= -1;
    std::swap(lat1, lat2);
  }
  int latsign = lat1 < 0 ? 1 : -1;
  lat1 *= latsign;
  lat2 *= latsign;
  double sbet1, cbet1, sbet2, cbet2;
  sbet1 = std::sin(lat1 * degree) * (1 - f);
  cbet1 = std::cos(lat1 * degree);
  sbet2 = std::sin(lat2 * degree) * (1 - f);
  cbet2 = std::cos(lat2 * degree);
  double n1 = std::hypot(sbet1, cbet1), n2 = std::hypot(sbet2, cbet2);
  sbet1 /= n1;
  cbet1 = std::fmax(1e-150, cbet1 / n1);
  sbet2 /= n2;
  cbet2 = std::fmax(1e-150, cbet2 / n2);
  if (cbet1 < -sbet1) {
    if (cbet2 == cbet1) sbet2 = std::copysign(sbet1, sbet2);
  } else {
    if (std::fabs(sbet2) == -sbet1) cbet2 = cbet1;
  }
  double const slam = std::sin(lon12 * degree), clam = std::cos(lon12 * degree);
  double const sbet12 = sbet2 * cbet1 - cbet2 * sbet1;
  bool const shortline = sbet12 < 0.5 && cbet2 * lon12 < 30;
  double x = shortline ? sbet12 + cbet2 * sbet1 * sq(slam) / (1 + std::fabs(clam)) : sbet2 * cbet1 - cbet2 * sbet1 * clam;
  double y = cbet2 * slam, z = sbet1 * sbet2 + cbet1 * cbet2 * clam;
  double const h = std::hypot(x, y);
  out[0] = h < 0.1 && z > 0 ? std::asin(h) : std::acos(std::fmin(1.0, std::fmax(-1.0, z)));
  out[1] = swapp * lonsign * y;
  out[2] = swapp * latsign * x;
}

#pragma symreal function input(psi) range(-100, 100) input(a) range(0.1, 1) input(b) range(0.1, 3) output(out[0:2])
void latitude(double psi, double a, double b, double *out) {
  out[0] = std::atan(tauf(psi)) / degree;
  out[1] = bracketed(a, b);
}

int main() {
  double out[3];
  reduce(170, -175, out);
  std::printf("%g\n", out[0] + out[1] + out[2]);
  sine_cosine(40, out);
  std::printf("%g\n", out[0] + out[1] + out[2] + area(0.5, 0.25));
  distance(40, -30, 60, out);
  std::printf("%g\n", out[0] + out[1] + out[2]);
  latitude(1.5, 0.5, 1.5, out);
  std::printf("%g\n", out[0] + out[1]);
}
