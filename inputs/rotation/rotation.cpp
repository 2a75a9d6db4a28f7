// A constant 3x3 matrix seen from a frame that is turned about z by the angle q. Only the first column of the product
// is wanted; the program computes all of it.
#include <cmath>
#include <cstdio>
#include <cstdlib>

void multiply(double const A[3][3], double const B[3][3], double C[3][3]) {
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) C[i][j] = A[i][0] * B[0][j] + A[i][1] * B[1][j] + A[i][2] * B[2][j];
}

int main(int argc, char **argv) {
  double const degree = 3.14159265358979323846 / 180.0;
  double const b[3][3] = {{10.0, 0.5, 0.0}, {0.5, 5.1, 0.7}, {0.0, 0.7, 10.0}};
  double q = (argc > 1 ? std::atof(argv[1]) : 30.0) * degree;
  double c[3][3];

#pragma symreal input(q)
  double a[3][3] = {{std::cos(q), std::sin(q), 0.0}, {-std::sin(q), std::cos(q), 0.0}, {0.0, 0.0, 1.0}};
  multiply(a, b, c);
#pragma symreal output(c[0:3][0]) generate("rotation.c")

  for (int i = 0; i < 3; i++) std::printf("%.17g\n", c[i][0]);
}
