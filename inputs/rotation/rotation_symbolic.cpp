// The direction-cosine example as a symbolic main written by hand. Compiled with -DMBD_SYMBOLIC it writes the code of
// the first column of the product; without, it is the numeric program.
#include <symreal/symbolic_main.h>

#include <stdio.h>

static void multiply(REAL const A[3][3], REAL const B[3][3], REAL C[3][3]) {
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) C[i][j] = A[i][0] * B[0][j] + A[i][1] * B[1][j] + A[i][2] * B[2][j];
}

int main() {
  REAL const b[3][3] = {{10.0, 0.5, 0.0}, {0.5, 5.1, 0.7}, {0.0, 0.7, 10.0}};
  REAL q = create_runtime_const("q", 30 * PI / 180);
  REAL a[3][3] = {{COS(q), SIN(q), 0.0}, {-SIN(q), COS(q), 0.0}, {0.0, 0.0, 1.0}};
  REAL c[3][3];
  multiply(a, b, c);
  REAL column[3] = {c[0][0], c[1][0], c[2][0]};
  output("c", column);
#ifndef MBD_SYMBOLIC
  for (int i = 0; i < 3; i++) printf("%.17g\n", column[i]);
#endif
  generate_code("rotation_symbolic.c");
}
