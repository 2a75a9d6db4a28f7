#include "verify/single_runs.h"

#include "runtime/replay/compare.h"

#include <algorithm>

namespace symreal::program {

// Less than 1: the optimised code rounds at other places than the recorded graph.
constexpr static double share_of_tolerance = 0.25;

Sample in_single_precision(Sample sample) {
  for (std::vector<double> *values : {&sample.inputs, &sample.parameters})
    for (double &value : *values) value = rounded(value, Rounding::to_single);
  return sample;
}

SingleRuns::SingleRuns(Graph const &graph, Sample const &sample) {
  for (Rounding rounding : {Rounding::to_single, Rounding::up_to_single, Rounding::down_to_single})
    runs_.push_back(evaluate_sample(graph, sample.inputs, sample.parameters, {}, rounding));
}

Premises SingleRuns::premises() const {
  Premises all;
  for (Evaluation const &run : runs_) {
    all.finite = all.finite && run.premises.finite;
    all.zero_sign_unseen = all.zero_sign_unseen && run.premises.zero_sign_unseen;
    all.defined = all.defined && run.premises.defined;
  }
  return all;
}

bool SingleRuns::decide_otherwise(std::size_t failing_guard) const {
  return std::ranges::any_of(runs_, [&](Evaluation const &run) { return run.failing_guard != failing_guard; });
}

bool SingleRuns::lose(std::size_t slot, double original, double tolerance) const {
  return std::ranges::any_of(runs_, [&](Evaluation const &run) {
    return !same(original, run.outputs[slot], FloatingPoint::fast, share_of_tolerance * tolerance);
  });
}

} // namespace symreal::program
