/* A hexahedral finite element with one point of integration: nodal forces against hourglass modes, the deformations that
   this point does not see, after Flanagan and Belytschko (1981), and the rate of deformation at the point. Two kernels,
   written as element codes are: loops over 8 nodes, 4 modes and 3 axes. */
#include <stdio.h>

enum { axes = 3, nodes = 8, modes = 4 };

/* Derivatives of the shape functions by the coordinates of the reference cube, times 8. */
static double const shape[axes][nodes] = {
    {-1, 1, 1, -1, -1, 1, 1, -1}, {-1, -1, 1, 1, -1, -1, 1, 1}, {-1, -1, -1, -1, 1, 1, 1, 1}};
static double const hourglass[modes][nodes] = {{1, 1, -1, -1, -1, -1, 1, 1},
                                               {1, -1, -1, 1, -1, 1, 1, -1},
                                               {1, -1, 1, -1, 1, -1, 1, -1},
                                               {-1, 1, -1, 1, 1, -1, 1, -1}};

/* The volume at the point, and its derivatives by the coordinates of the nodes. */
static double volume_gradient(double const x[axes][nodes], double gradient[axes][nodes]) {
  double jacobian[axes][axes], cofactor[axes][axes];
  for (int i = 0; i < axes; ++i)
    for (int k = 0; k < axes; ++k) {
      double sum = 0;
      for (int n = 0; n < nodes; ++n) sum += shape[k][n] * x[i][n];
      jacobian[i][k] = 0.125 * sum;
    }
  for (int i = 0; i < axes; ++i)
    for (int k = 0; k < axes; ++k) {
      int const i1 = (i + 1) % axes, i2 = (i + 2) % axes, k1 = (k + 1) % axes, k2 = (k + 2) % axes;
      cofactor[i][k] = jacobian[i1][k1] * jacobian[i2][k2] - jacobian[i1][k2] * jacobian[i2][k1];
    }
  for (int i = 0; i < axes; ++i)
    for (int n = 0; n < nodes; ++n) {
      double sum = 0;
      for (int k = 0; k < axes; ++k) sum += cofactor[i][k] * shape[k][n];
      gradient[i][n] = sum;
    }
  return 8 * (jacobian[0][0] * cofactor[0][0] + jacobian[0][1] * cofactor[0][1] + jacobian[0][2] * cofactor[0][2]);
}

#pragma symreal function input(x[0:3][0:8], v[0:3][0:8]) range(-1, 1) input(damping) range(0.1, 1) output(force[0:3][0:8])
void hourglass_force(double const x[axes][nodes], double const v[axes][nodes], double damping,
                     double force[axes][nodes]) {
  double gradient[axes][nodes], mode[modes][nodes];
  double const inverse = 1 / volume_gradient(x, gradient);
  for (int m = 0; m < modes; ++m) {
    double part[axes];
    for (int i = 0; i < axes; ++i) {
      part[i] = 0;
      for (int n = 0; n < nodes; ++n) part[i] += hourglass[m][n] * x[i][n];
    }
    for (int n = 0; n < nodes; ++n)
      mode[m][n] =
          hourglass[m][n] - inverse * (gradient[0][n] * part[0] + gradient[1][n] * part[1] + gradient[2][n] * part[2]);
  }
  for (int i = 0; i < axes; ++i) {
    double rate[modes];
    for (int m = 0; m < modes; ++m) {
      rate[m] = 0;
      for (int n = 0; n < nodes; ++n) rate[m] += mode[m][n] * v[i][n];
    }
    for (int n = 0; n < nodes; ++n) {
      double sum = 0;
      for (int m = 0; m < modes; ++m) sum += mode[m][n] * rate[m];
      force[i][n] = -damping * sum;
    }
  }
}

#pragma symreal function input(x[0:3][0:8], v[0:3][0:8]) range(-1, 1) output(rate[0:6])
void deformation_rate(double const x[axes][nodes], double const v[axes][nodes], double rate[6]) {
  double gradient[axes][nodes], slope[axes][axes];
  double const inverse = 1 / volume_gradient(x, gradient);
  for (int i = 0; i < axes; ++i)
    for (int k = 0; k < axes; ++k) {
      slope[i][k] = 0;
      for (int n = 0; n < nodes; ++n) slope[i][k] += v[i][n] * gradient[k][n];
      slope[i][k] *= inverse;
    }
  for (int i = 0; i < axes; ++i) {
    int const k = (i + 1) % axes;
    rate[i] = slope[i][i];
    rate[axes + i] = 0.5 * (slope[i][k] + slope[k][i]);
  }
}

int main(void) {
  double x[axes][nodes], v[axes][nodes], force[axes][nodes], rate[6];
  for (int i = 0; i < axes; ++i)
    for (int n = 0; n < nodes; ++n) {
      x[i][n] = 0.5 * shape[i][n] + 0.03 * ((5 * n + 3 * i) % 7);
      v[i][n] = 0.1 * ((3 * n + 5 * i) % 11) - 0.4;
    }
  hourglass_force(x, v, 0.25, force);
  deformation_rate(x, v, rate);
  for (int i = 0; i < axes; ++i)
    for (int n = 0; n < nodes; ++n) printf("force[%d][%d] = %.17g\n", i, n, force[i][n]);
  for (int k = 0; k < 6; ++k) printf("rate[%d] = %.17g\n", k, rate[k]);
  return 0;
}
