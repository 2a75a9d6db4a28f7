// How far the original and the generated code are from the exact values: those of the recorded graph in so many bits
// that rounding does not show.
#pragma once

#include "runtime/replay/samples.h"
#include "verify/exact_outputs.h"

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
  std::size_t left_out = 0;            // besides: they would take too long
  std::vector<ErrorsOfOutput> outputs; // per slot
};

// Adds what other samples have shown.
void join(ErrorResult &result, ErrorResult const &other);

class ExactErrors {
public:
  ExactErrors(Graph const &graph, unsigned bits);

  // Sample k, at which the nodes have `values` in double precision; none are needed where there is an obstacle. Whether
  // an error is the largest so far.
  bool compare(std::size_t k, Sample const &sample, std::span<double const> values, std::span<double const> original,
               std::span<double const> generated);

  ErrorResult const &result() const { return result_; }

private:
  Graph const &graph_;
  ExactOutputs outputs_;
  double operations_ = 0; // so far
  ErrorResult result_;
};

} // namespace symreal::program
