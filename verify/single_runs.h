// Runs of the recorded graph in single precision, rounding each number to nearest, down and up: if they are far from
// the original, float code cannot be expected to be near.
#pragma once

#include "engine/graph/evaluate.h"
#include "runtime/replay/samples.h"

#include <vector>

namespace symreal::program {

// Rounds the sample to float, for the generated code and the original alike.
Sample in_single_precision(Sample sample);

class SingleRuns {
public:
  SingleRuns(Graph const &graph, Sample const &sample);

  // Premises that hold in all runs: no run leaves the range of float or the defined domain.
  Premises premises() const;
  // Does a run stop at another guard than the original, or at none?
  bool decide_otherwise(std::size_t failing_guard) const;
  // Is a run farther from the original's number than a fraction of the tolerance?
  bool lose(std::size_t slot, double original, double tolerance) const;

private:
  std::vector<Evaluation> runs_;
};

} // namespace symreal::program
