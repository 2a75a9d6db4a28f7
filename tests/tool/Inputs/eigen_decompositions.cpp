// One kernel for each way in which Eigen solves a small system of equations.
#include <Eigen/Dense>
#include <cstdio>

using Matrix = Eigen::Map<Eigen::Matrix<double, 3, 3> const>;
using Vector = Eigen::Map<Eigen::Matrix<double, 3, 1> const>;
using Result = Eigen::Map<Eigen::Matrix<double, 3, 1>>;

#pragma symreal function input(a[0:9], b[0:3]) output(x[0:3])
void inverse(double const *a, double const *b, double *x) {
  Result r(x);
  r = Matrix(a).inverse() * Vector(b);
}

#pragma symreal function input(a[0:9], b[0:3]) output(x[0:3])
void llt(double const *a, double const *b, double *x) {
  Result r(x);
  r = Matrix(a).llt().solve(Vector(b));
}

#pragma symreal function input(a[0:9], b[0:3]) output(x[0:3])
void ldlt(double const *a, double const *b, double *x) {
  Result r(x);
  r = Matrix(a).ldlt().solve(Vector(b));
}

#pragma symreal function input(a[0:9], b[0:3]) output(x[0:3])
void partial_piv_lu(double const *a, double const *b, double *x) {
  Result r(x);
  r = Matrix(a).partialPivLu().solve(Vector(b));
}

#pragma symreal function input(a[0:9], b[0:3]) output(x[0:3])
void full_piv_lu(double const *a, double const *b, double *x) {
  Result r(x);
  r = Matrix(a).fullPivLu().solve(Vector(b));
}

#pragma symreal function input(a[0:9], b[0:3]) output(x[0:3])
void col_piv_qr(double const *a, double const *b, double *x) {
  Result r(x);
  r = Matrix(a).colPivHouseholderQr().solve(Vector(b));
}

int main() {
  double const a[9] = {4, 1, 0.5, 1, 3, 0.25, 0.5, 0.25, 2}, b[3] = {1, 2, 3};
  double x[3];
  for (auto solve : {inverse, llt, ldlt, partial_piv_lu, full_piv_lu, col_piv_qr}) {
    solve(a, b, x);
    std::printf("%.15g %.15g %.15g\n", x[0], x[1], x[2]);
  }
}
