// The logarithm of the posterior of a mixture of Gaussians with a Wishart prior, by the formulas of the automatic-
// differentiation benchmark of F. Srajer, Z. Kukelova and A. Fitzgibbon (2018; see bundle.cpp). x: logarithms of the
// weights, means, and of each inverse covariance factor the logarithms of the diagonal and what stands below it; z: the
// points.
#include <cmath>

#ifndef COMPONENTS
#define COMPONENTS 5
#define POINTS 10
#endif
enum { K = COMPONENTS, N = POINTS, D = 2, FACTOR = D * (D + 1) / 2, INPUTS = K * (1 + D + FACTOR) };

static double log_sum_exp(double const *x, int n) {
  double largest = x[0], sum = 0.0;
  for (int i = 1; i < n; i++) largest = std::fmax(largest, x[i]);
  for (int i = 0; i < n; i++) sum += std::exp(x[i] - largest);
  return std::log(sum) + largest;
}

void model(double const *x, double const *z, double *y) {
  double const gamma = 1.0, degrees = 0.0, pi = 3.14159265358979323846;
  double const *alpha = x, *mean = x + K, *factor = x + K * (1 + D);
  double diagonal[K][D], trace[K], prior = 0.0, fit = 0.0;
  for (int k = 0; k < K; k++) {
    trace[k] = 0.0;
    double squares = 0.0;
    for (int i = 0; i < D; i++) {
      trace[k] += factor[k * FACTOR + i];
      diagonal[k][i] = std::exp(factor[k * FACTOR + i]);
      squares += diagonal[k][i] * diagonal[k][i];
    }
    for (int i = D; i < FACTOR; i++) squares += factor[k * FACTOR + i] * factor[k * FACTOR + i];
    prior += 0.5 * gamma * gamma * squares - degrees * trace[k];
  }
  for (int n = 0; n < N; n++) {
    double term[K];
    for (int k = 0; k < K; k++) {
      double centred[D], squares = 0.0;
      for (int i = 0; i < D; i++) centred[i] = z[n * D + i] - mean[k * D + i];
      double const *below = factor + k * FACTOR + D;
      for (int i = 0; i < D; i++) {
        double row = diagonal[k][i] * centred[i];
        for (int j = 0; j < i; j++) row += *below++ * centred[j];
        squares += row * row;
      }
      term[k] = alpha[k] + trace[k] - 0.5 * squares;
    }
    fit += log_sum_exp(term, K);
  }
  /* The prior's normalisation, degrees = 0: D + 1 degrees of freedom. */
  double const freedom = D + degrees + 1.0;
  double const of_gamma =
      0.25 * D * (D - 1) * std::log(pi) + std::lgamma(0.5 * freedom) + std::lgamma(0.5 * (freedom - 1.0));
  double const normal = freedom * D * (std::log(gamma) - 0.5 * std::log(2.0)) - of_gamma;
  y[0] = -0.5 * N * D * std::log(2.0 * pi) + fit - N * log_sum_exp(alpha, K) + prior - K * normal;
}
