// Errors of the original and of the generated code against exact values: the recorded graph evaluated in enough bits
// that rounding does not show.
#pragma once

#include "engine/graph/graph.h"
#include "runtime/replay/samples.h"
#include "verify/multiprecision.h"

#include <span>
#include <string>
#include <vector>

namespace symreal::program {

// Range of precisions; the least exceeds that of long double.
inline constexpr unsigned least_exact_bits = 65, most_exact_bits = 65536;

// Evaluates one operation; operations on integers as in double precision.
Multiprecision evaluate_exact(Op op, Multiprecision const &x, Multiprecision const &y, Multiprecision const &z);

// Multiprecision evaluator of a graph without obstacles (obstacle_to_extended).
class ExactOutputs {
public:
  ExactOutputs(Graph const &graph, unsigned bits);

  // Evaluates at these inputs, where the nodes have `values` in double precision. False if a decision differs in more
  // bits, so that another formula would hold.
  bool move_to(std::span<double const> inputs, std::span<double const> parameters, std::span<double const> values);

  // Error of a number against this output, relative to max(|output|, 1).
  double error_of(std::size_t slot, double number) const;

private:
  Graph const &graph_;
  std::vector<Multiprecision> outputs_;
};

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
