// Verdicts in mode fast: if generated code and original differ beyond the tolerance, the recorded graph in extended
// precision tells which one is wrong.
#pragma once

#include "engine/graph/graph.h"
#include "runtime/replay/compare.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace symreal::program {

// The verdict on one output.
struct OutputErrors {
  std::size_t calls = 0;              // calls in which the code is as accurate as the original
  double original = 0, generated = 0; // largest errors in these calls
  // Errors in the worst of the calls in which the code is less accurate.
  double failed_original = 0, failed_generated = 0;
};

struct ExactJudgement {
  std::string obstacle;   // reason why it could not tell, if it was asked
  std::size_t calls = 0;  // calls that it was asked about
  std::size_t untold = 0; // of these, calls in which a decision differs in extended precision
  std::vector<OutputErrors> outputs;
};

// Number of inputs examined near a sample, and their distance relative to each of its numbers.
inline constexpr int neighbours = 16;
inline constexpr double neighbourhood = 0x1p-36;

// Judge of outputs, called output by output, call by call.
class ExactValues {
public:
  explicit ExactValues(Graph const &graph);

  // Begins another call. The graph must reproduce the original's values, or it cannot judge the call.
  void begin(std::span<double const> inputs, std::span<double const> parameters);
  // Is the generated number as accurate as the original's? The original may be accurate by chance, so its error is the
  // largest at the sample and its neighbours.
  bool accepts(std::size_t slot, double original, double generated, double tolerance);

  ExactJudgement const &judgement() const { return judgement_; }

private:
  // Output values in double precision and in extended precision.
  struct Point {
    std::vector<double> in_double;
    std::vector<long double> exact;
  };
  std::optional<Point> at(std::vector<double> const &inputs, std::vector<double> const &parameters) const;
  void evaluate_call();
  void look_at_neighbours();

  Graph const &graph_;
  std::vector<double> inputs_, parameters_;
  bool is_evaluated_ = false;
  std::optional<Point> point_;
  std::vector<double> neighbour_errors_; // largest per output; empty until first needed
  ExactJudgement judgement_;
};

} // namespace symreal::program
