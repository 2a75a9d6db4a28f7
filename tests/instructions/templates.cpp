// Templates that ask whether their number is a double. Ranges, states and derivatives of the pragma hold as well.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %symreal generate %s -o code.c --record=instructions > table 2>&1
// RUN: FileCheck %s < table
// CHECK-NOT: warning
// CHECK: kernel track: 5 inputs, 0 parameters, 12 outputs
// RUN: FileCheck %s --check-prefix=C < code.c
// C: "from":"instructions","derivatives":["jacobian(next, x)"]
// RUN: %symreal verify %s code.c --samples=100 > verified 2>&1 && FileCheck %s --check-prefix=SAME < verified
// SAME: kernel track, mode finite: 100 samples{{.*}} 100 within the premises
#include <cmath>
#include <type_traits>

namespace third_party {
template <class T> struct traits;
template <> struct traits<double> {
  static constexpr double step = 0.1;
};
template <class T, int n> struct vec {
  static_assert(std::is_floating_point_v<T> && sizeof(T) == 8, "numbers only");
  T at[n];
  template <class F> vec map(F const &f) const {
    vec result;
    for (int k = 0; k < n; ++k) result.at[k] = f(at[k], k);
    return result;
  }
};
template <class T> T wrapped(T angle) { return std::atan2(std::sin(angle), std::cos(angle)); }
template double wrapped<double>(double);
} // namespace third_party

#pragma symreal function input(x) range(-1, 1) input(u) range(0.5, 1) output(next) jacobian(next, x)
void track(double const (&x)[3], double const (&u)[2], double (&next)[3]) {
  using third_party::vec;
  constexpr double h = third_party::traits<std::remove_cv_t<std::remove_reference_t<decltype(x[0])>>>::step;
  vec<double, 3> const now{{x[0], x[1], x[2]}};
  vec<double, 3> const then = now.map([&](double v, int k) {
    return k == 2 ? third_party::wrapped(v + h * u[1]) : v + h * u[0] * (k == 0 ? std::cos(x[2]) : std::sin(x[2]));
  });
  for (int k = 0; k < 3; ++k) next[k] = then.at[k];
}

int main() {
  double const x[] = {0.1, 0.2, 0.3}, u[] = {0.7, 0.6};
  double next[3];
  track(x, u, next);
  return next[0] == 0;
}
