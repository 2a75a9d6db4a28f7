// What single precision itself makes of a sample: the recorded graph, each of its numbers rounded to float, to the
// nearest and to either side. Where these are not near the original, no code in float can be expected to be.
#pragma once

#include "engine/graph/evaluate.h"
#include "runtime/replay/samples.h"

#include <vector>

namespace symreal::program {

// Generated code in float and the original are given the same numbers.
Sample in_single_precision(Sample sample);

class SingleRuns {
public:
  SingleRuns(Graph const &graph, Sample const &sample);

  // Where one of them leaves the range of a float, or what is defined.
  Premises premises() const;
  // One of them stops at another guard than the original, or at none.
  bool decide_otherwise(std::size_t failing_guard) const;
  // One of them is farther from the original's number than a fraction of the tolerance.
  bool lose(std::size_t slot, double original, double tolerance) const;

private:
  std::vector<Evaluation> runs_;
};

} // namespace symreal::program
