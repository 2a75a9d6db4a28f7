// As rotation.cpp, with the whole product as output, and with the kernel in a function of its own.
#include <cmath>
#include <cstdio>
#include <cstdlib>

void multiply(double const A[3][3], double const B[3][3], double C[3][3]) {
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) C[i][j] = A[i][0] * B[0][j] + A[i][1] * B[1][j] + A[i][2] * B[2][j];
}

static double const b[3][3] = {{10.0, 0.5, 0.0}, {0.5, 5.1, 0.7}, {0.0, 0.7, 10.0}};

#pragma symreal function input(q) output(c[0:3][0:3])
void rotated(double q, double c[3][3]) {
  double a[3][3] = {{0.0}};
  a[0][0] = a[1][1] = std::cos(q);
  a[0][1] = std::sin(q);
  a[1][0] = -std::sin(q);
  a[2][2] = 1.0;
  multiply(a, b, c);
}

int main(int argc, char **argv) {
  double const degree = 3.14159265358979323846 / 180.0;
  double c[3][3];
  rotated((argc > 1 ? std::atof(argv[1]) : 30.0) * degree, c);
  for (int i = 0; i < 3; i++) std::printf("%.17g %.17g %.17g\n", c[i][0], c[i][1], c[i][2]);
}
