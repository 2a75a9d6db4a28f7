// A x = b by A = L D L^T, without pivoting: for positive definite A. Overwrites A; b becomes x.
#pragma once

template <int n> void solve(double (&A)[n][n], double (&b)[n]) {
  for (int j = 0; j < n; j++) {
    for (int i = j + 1; i < n; i++) {
      double const factor = A[i][j] / A[j][j];
      for (int k = j + 1; k <= i; k++) A[i][k] -= factor * A[k][j];
      b[i] -= factor * b[j];
    }
  }
  for (int j = n - 1; j >= 0; j--) {
    for (int i = j + 1; i < n; i++) b[j] -= A[i][j] * b[i];
    b[j] = b[j] / A[j][j];
  }
}
