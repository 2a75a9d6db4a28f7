#include "@BASE@.hpp"

#include <chrono>
#include <cstdio>

static double values[@INPUTS@ + @PARAMETERS@ + 1], constants[@CONSTANTS@ + 1], output[@OUTPUTS@ + 1];

int main() {
  std::FILE *file = std::fopen("values", "r");
  long calls;
  for (int i = 0; std::fscanf(file, "%lf", &values[i]) == 1; ++i) {}
  double const first = values[0];
  @NAMESPACE@::preprocess(values + @INPUTS@, constants);
  while (std::scanf("%ld", &calls) == 1) {
    double sum = 0.0;
    auto const begin = std::chrono::steady_clock::now();
    for (long i = 0; i < calls; ++i) {
      values[0] = first + 1e-7 * static_cast<double>(i & 15);
      @NAMESPACE@::compute(values, constants, output);
      sum += output[0];
    }
    std::chrono::duration<double, std::nano> const time = std::chrono::steady_clock::now() - begin;
    std::printf("%.17g %.17g\n", time.count() / static_cast<double>(calls), sum);
    std::fflush(stdout);
  }
}
