// The covariance of N states one step on: F P F' + Q.
#include <cstdlib>
#include <vector>

#pragma symreal function input(F[0 : n * n], P[0 : n * n], Q[0 : n * n]) constant(n) output(next[0 : n * n])
void predict(double const *F, double const *P, double const *Q, int n, double *next) {
  std::vector<double> product(n * n);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++)
      for (int k = 0; k < n; k++) product[n * i + j] += F[n * i + k] * P[n * k + j];
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) {
      double sum = Q[n * i + j];
      for (int k = 0; k < n; k++) sum += product[n * i + k] * F[n * j + k];
      next[n * i + j] = sum;
    }
}

#ifndef NO_MAIN
int main(int, char **argv) {
  int const n = std::atoi(argv[1]);
  std::vector<double> F(n * n, 0.1), P(n * n, 0.2), Q(n * n, 0.3), next(n * n);
  predict(F.data(), P.data(), Q.data(), n, next.data());
}
#endif
