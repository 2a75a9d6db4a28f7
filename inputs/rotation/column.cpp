// The first column of the product of a rotation about z by q and a matrix in which r stands: the column does not depend on
// r. Its graph is the published figure. With -DTWO the first number of the column is no output.
#include <cmath>
#include <cstdio>

void multiply(double const A[3][3], double const B[3][3], double C[3][3]) {
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) C[i][j] = A[i][0] * B[0][j] + A[i][1] * B[1][j] + A[i][2] * B[2][j];
}

int main() {
  double q = 3.14159265358979323846 / 6, r = 5.1;
  double c[3][3];

#pragma symreal input(q, r)
  double const a[3][3] = {{std::cos(q), std::sin(q), 0.0}, {-std::sin(q), std::cos(q), 0.0}, {0.0, 0.0, 1.0}};
  double const b[3][3] = {{10.0, 0.5, 0.0}, {0.5, r, 0.7}, {0.0, 0.7, 10.0}};
  multiply(a, b, c);
#ifdef TWO
#pragma symreal output(c[1:2][0]) generate("column.c")
#else
#pragma symreal output(c[0:3][0]) generate("column.c")
#endif

  for (int i = 0; i < 3; i++) std::printf("%.17g\n", c[i][0]);
}
