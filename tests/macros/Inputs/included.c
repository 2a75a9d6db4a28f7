#pragma symreal function input(x[0:N]) output(y[0:T])
void move(double const *x, double *y) {
  for (int i = 0; i < T; ++i) y[i] = offset(x[i]) * x[N - 1];
}
int main(void) {
  double x[N] = {1, 2, 3, 4, 5, 6}, y[T];
  move(x, y);
  return 0;
}
