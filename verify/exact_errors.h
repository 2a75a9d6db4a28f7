// Errors of the original and of the generated code against exact values: the recorded graph evaluated in enough bits
// that rounding does not show.
#pragma once

#include "runtime/replay/samples.h"
#include "verify/exact_outputs.h"

#include <string>

namespace symreal::program {

// Errors of one output, relative to max(|exact value|, 1).
struct ErrorsOfOutput {
  double original = 0, generated = 0;                    // largest errors
  std::size_t original_nearer = 0, generated_nearer = 0; // samples
  std::size_t worst_sample = 0;                          // sample with the largest error of either
  bool has_worst() const { return original != 0 || generated != 0; }
};

struct ErrorResult {
  unsigned bits = 0;
  std::string obstacle;                // reason why there are no exact values, in words
  std::size_t samples = 0;             // samples evaluated
  std::size_t untold = 0;              // samples on which a decision differs in exact numbers, or a value is not finite
  std::size_t left_out = 0;            // samples skipped for lack of time
  std::vector<ErrorsOfOutput> outputs; // per slot
};

// Adds the results of other samples.
void join(ErrorResult &result, ErrorResult const &other);

class ExactErrors {
public:
  ExactErrors(Graph const &graph, unsigned bits);

  // Evaluates sample k, where the nodes have `values` in double precision (unused if there is an obstacle). True if an
  // error is the largest so far.
  bool compare(std::size_t k, Sample const &sample, std::span<double const> values, std::span<double const> original,
               std::span<double const> generated);

  ErrorResult const &result() const { return result_; }

private:
  Graph const &graph_;
  ExactOutputs outputs_;
  double operations_ = 0; // operations evaluated so far
  ErrorResult result_;
};

} // namespace symreal::program
