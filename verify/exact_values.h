// Mode fast: where generated code is farther from the original than the tolerance, either may be the one that is wrong.
// The recorded graph in extended precision tells.
#pragma once

#include "engine/graph/graph.h"
#include "runtime/replay/compare.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace symreal::program {

// What it told of one output.
struct OutputErrors {
  std::size_t calls = 0;              // in which the code is as near as the original
  double original = 0, generated = 0; // the largest errors on these
  // Where the code is too far off, the worst of it.
  double failed_original = 0, failed_generated = 0;
};

struct ExactJudgement {
  std::string obstacle;   // why it cannot tell, if it was asked and cannot
  std::size_t calls = 0;  // of which it was asked
  std::size_t untold = 0; // of these, in which a decision falls otherwise in extended precision
  std::vector<OutputErrors> outputs;
};

// How many inputs near a sample are looked at as well, and how near, relative to each of its numbers.
inline constexpr int neighbours = 16;
inline constexpr double neighbourhood = 0x1p-36;

// Asked of one output after the other, of one call after the other.
class ExactValues {
public:
  explicit ExactValues(Graph const &graph);

  // Another call. The original gives what the graph does, or the graph tells nothing of it.
  void begin(std::span<double const> inputs, std::span<double const> parameters);
  // Whether the generated number is as near to the exact one as the original's. The original may be near by chance, so
  // its error is the largest there and at the neighbours.
  bool accepts(std::size_t slot, double original, double generated, double tolerance);

  ExactJudgement const &judgement() const { return judgement_; }

private:
  // Per output, in double precision and exactly; nothing where it does not tell.
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
  std::vector<double> neighbour_errors_; // per output the largest; empty until they are looked at
  ExactJudgement judgement_;
};

} // namespace symreal::program
