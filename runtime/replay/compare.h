// When an output of the generated code is the same as the original's, by mode, and how far apart two doubles are.
#pragma once

#include "engine/ops/floating_point.h"

#include <cstdint>
#include <vector>

namespace symreal {

// How many doubles lie between: 0 for equal numbers (0 and -0 are equal) and for two NaNs, the largest count for a NaN
// and a number.
std::uint64_t ulp_distance(double a, double b);
std::uint64_t ulp_distance(float a, float b);

// finite: ==. strict: the same bits, any NaN equal to any NaN. fast: within `tolerance`, relative to the larger of the
// original's magnitude and 1.
bool same(double original, double generated, FloatingPoint mode, double tolerance);

// Mode fast, beyond the tolerance: a number that is as near to the exact one as the original's is not worse than that.
// "As near" is not farther than so many times the original's distance, and the tolerance.
inline constexpr double most_times_as_far = 4;
bool is_as_near(double error, double original_error, double tolerance);
// How far a number is from the exact one, relative to the larger of its magnitude and 1.
double error_of(double number, long double exact);

// What is known of one output after the samples so far.
struct OutputComparison {
  std::size_t different = 0; // samples
  std::uint64_t worst_ulp = 0;
  std::size_t worst_sample = 0;
  double original = 0, generated = 0; // at the worst sample

  // Whether this sample is the worst now.
  bool add(std::size_t sample, double original_value, double generated_value, FloatingPoint mode, double tolerance);
  // Of what is the same in another way.
  bool add_same(std::size_t sample, double original_value, double generated_value);
  // Of code in single precision: within `tolerance`, and distances are those of floats.
  bool add_single(std::size_t sample, double original_value, double generated_value, double tolerance);
  // What is known of the same output after other samples.
  void join(OutputComparison const &other);

  // Whether a worst sample is known: one that is not equal.
  bool has_worst() const { return worst_ulp != 0 || different != 0; }

private:
  bool add(std::size_t sample, double original_value, double generated_value, bool is_same, std::uint64_t distance);
};

} // namespace symreal
