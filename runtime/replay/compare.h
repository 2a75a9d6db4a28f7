// Comparison of an output of the generated code with the original's, by mode, and the distance between two doubles.
#pragma once

#include "engine/ops/floating_point.h"

#include <cstdint>
#include <vector>

namespace symreal {

// Number of doubles in between: 0 for equal numbers (0 and -0 are equal) and for two NaNs, the largest count for a NaN
// and a number.
std::uint64_t ulp_distance(double a, double b);
std::uint64_t ulp_distance(float a, float b);

// finite: ==. strict: the same bits, any NaN equal to any NaN. fast: within `tolerance`, relative to the larger of the
// original's magnitude and 1.
bool same(double original, double generated, FloatingPoint mode, double tolerance);

// Mode fast, beyond the tolerance: a number about as near to the exact one as the original's is accepted: at most so
// many times the original's distance, plus the tolerance.
inline constexpr double most_times_as_far = 4;
bool is_as_near(double error, double original_error, double tolerance);
// Distance of a number from the exact one, relative to the larger of its magnitude and 1.
double error_of(double number, long double exact);

// Comparison results for one output after the samples so far.
struct OutputComparison {
  std::size_t different = 0; // samples
  std::uint64_t worst_ulp = 0;
  std::size_t worst_sample = 0;
  double original = 0, generated = 0; // at the worst sample

  // Adds a sample; returns whether it is the worst so far.
  bool add(std::size_t sample, double original_value, double generated_value, FloatingPoint mode, double tolerance);
  // Adds a sample that another criterion accepts as the same.
  bool add_same(std::size_t sample, double original_value, double generated_value);
  // Adds a sample of single-precision code: compared within `tolerance`, distances in floats.
  bool add_single(std::size_t sample, double original_value, double generated_value, double tolerance);
  // Adds the results for the same output from other samples.
  void join(OutputComparison const &other);

  // Whether a worst sample, one that is not equal, is known.
  bool has_worst() const { return worst_ulp != 0 || different != 0; }

private:
  bool add(std::size_t sample, double original_value, double generated_value, bool is_same, std::uint64_t distance);
};

} // namespace symreal
