#include "runtime/replay/compare.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace symreal {

// Numbers in order, as integers: both zeros are 0.
static std::int64_t rank(double value) {
  auto bits = std::bit_cast<std::int64_t>(value);
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
}

static std::int64_t rank(float value) {
  auto bits = std::bit_cast<std::int32_t>(value);
  return bits < 0 ? std::int64_t{std::numeric_limits<std::int32_t>::min()} - bits : bits;
}

template <class Real> static std::uint64_t distance_of(Real a, Real b) {
  if (std::isnan(a) || std::isnan(b))
    return std::isnan(a) && std::isnan(b) ? 0 : std::numeric_limits<std::uint64_t>::max();
  auto low = static_cast<std::uint64_t>(std::min(rank(a), rank(b)));
  auto high = static_cast<std::uint64_t>(std::max(rank(a), rank(b)));
  return high - low;
}

std::uint64_t ulp_distance(double a, double b) { return distance_of(a, b); }

std::uint64_t ulp_distance(float a, float b) { return distance_of(a, b); }

bool same(double original, double generated, FloatingPoint mode, double tolerance) {
  if (std::isnan(original) || std::isnan(generated))
    return mode != FloatingPoint::finite && std::isnan(original) && std::isnan(generated);
  switch (mode) {
  case FloatingPoint::strict: return std::bit_cast<std::uint64_t>(original) == std::bit_cast<std::uint64_t>(generated);
  case FloatingPoint::finite: return original == generated;
  case FloatingPoint::fast:
    return original == generated || std::abs(original - generated) <= tolerance * std::max(1.0, std::abs(original));
  }
  return false;
}

double error_of(double number, long double exact) {
  return static_cast<double>(std::fabs(number - exact) / std::fmax(1.0L, std::fabs(exact)));
}

bool is_as_near(double error, double original_error, double tolerance) {
  return error <= most_times_as_far * original_error + tolerance;
}

bool OutputComparison::add_same(std::size_t sample, double original_value, double generated_value) {
  return add(sample, original_value, generated_value, true, ulp_distance(original_value, generated_value));
}

bool OutputComparison::add(std::size_t sample, double original_value, double generated_value, FloatingPoint mode,
                           double tolerance) {
  return add(sample, original_value, generated_value, same(original_value, generated_value, mode, tolerance),
             ulp_distance(original_value, generated_value));
}

bool OutputComparison::add_single(std::size_t sample, double original_value, double generated_value, double tolerance) {
  return add(sample, original_value, generated_value,
             same(original_value, generated_value, FloatingPoint::fast, tolerance),
             ulp_distance(static_cast<float>(original_value), static_cast<float>(generated_value)));
}

bool OutputComparison::add(std::size_t sample, double original_value, double generated_value, bool is_same,
                           std::uint64_t distance) {
  bool first_difference = !is_same && different == 0;
  if (!is_same) ++different;
  // A difference that counts is shown before a larger one that does not.
  if (!first_difference && (distance <= worst_ulp || (is_same && different != 0))) return false;
  worst_ulp = distance;
  worst_sample = sample;
  original = original_value;
  generated = generated_value;
  return true;
}

void OutputComparison::join(OutputComparison const &other) {
  std::size_t const all = different + other.different;
  auto const key = [](OutputComparison const &one) { return std::pair(one.different != 0, one.worst_ulp); };
  bool const is_worse =
      key(other) > key(*this) || (key(other) == key(*this) && other.has_worst() && other.worst_sample < worst_sample);
  if (is_worse) *this = other;
  different = all;
}

} // namespace symreal
