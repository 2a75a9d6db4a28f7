// How far the original and the generated code are from the exact values: those of the recorded graph in so many bits
// that rounding does not show.
#pragma once

#include "program/exact_outputs.h"

#include <optional>
#include <string>

namespace symreal::program {

// Relative to the larger of the exact value's magnitude and 1.
struct ErrorsOfOutput {
  double original = 0, generated = 0;                    // the largest
  std::size_t original_nearer = 0, generated_nearer = 0; // samples
  std::size_t worst_sample = 0;                          // where one of them has its largest error
  bool has_worst() const { return original != 0 || generated != 0; }
};

struct ErrorResult {
  unsigned bits = 0;
  std::string obstacle;                // why there are no exact values, in words
  std::size_t samples = 0;             // that were looked at
  std::size_t untold = 0;              // besides: a decision falls otherwise in exact numbers, or a value is not finite
  std::size_t left_out = 0;            // besides: there were enough operations before them
  std::vector<ErrorsOfOutput> outputs; // per slot
};

// Adds what other samples have shown.
void join(ErrorResult &result, ErrorResult const &other);

class ExactErrors {
public:
  ExactErrors(Graph const &graph, unsigned bits);

  // Of one sample. Whether an error is the largest so far.
  bool compare(std::size_t sample, std::span<double const> inputs, std::span<double const> parameters,
               std::span<double const> original, std::span<double const> generated);

  ErrorResult const &result() const { return result_; }

private:
  Graph const &graph_;
  ExactOutputs outputs_;
  double operations_ = 0; // so far
  ErrorResult result_;
};

} // namespace symreal::program
