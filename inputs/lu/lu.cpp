// A x = b by Gaussian elimination with partial pivoting. Which rows are exchanged depends on the values: the order that
// was met while recording is recorded with its conditions (--decisions=guard).
#include <cmath>
#include <cstdio>
#include <utility>

constexpr int N = 4;

#pragma symreal function input(a[0:N][0:N], b[0:N]) output(x[0:N], return)
double solve(double const a[N][N], double const b[N], double x[N]) {
  double lu[N][N];
  int row[N];
  double determinant = 1.0;
  for (int i = 0; i < N; ++i) {
    row[i] = i;
    for (int j = 0; j < N; ++j) lu[i][j] = a[i][j];
  }
  for (int k = 0; k < N; ++k) {
    int pivot = k;
    for (int i = k + 1; i < N; ++i)
      if (std::fabs(lu[row[i]][k]) > std::fabs(lu[row[pivot]][k])) pivot = i;
    if (pivot != k) {
      std::swap(row[k], row[pivot]);
      determinant = -determinant;
    }
    if (lu[row[k]][k] == 0.0) return 0.0;
    determinant *= lu[row[k]][k];
    for (int i = k + 1; i < N; ++i) {
      double const factor = lu[row[i]][k] /= lu[row[k]][k];
      for (int j = k + 1; j < N; ++j) lu[row[i]][j] -= factor * lu[row[k]][j];
    }
  }
  for (int i = 0; i < N; ++i) {
    x[i] = b[row[i]];
    for (int j = 0; j < i; ++j) x[i] -= lu[row[i]][j] * x[j];
  }
  for (int i = N; i-- > 0;) {
    for (int j = i + 1; j < N; ++j) x[i] -= lu[row[i]][j] * x[j];
    x[i] /= lu[row[i]][i];
  }
  return determinant;
}

int main() {
  double const a[N][N] = {{1, 4, -2, 3}, {5, 1, 2, -1}, {2, -3, 7, 1}, {-1, 2, 1, 6}};
  double const b[N] = {1, 2, 3, 4};
  double x[N];
  double const determinant = solve(a, b, x);
  std::printf("%.12g: %.12g %.12g %.12g %.12g\n", determinant, x[0], x[1], x[2], x[3]);
}
