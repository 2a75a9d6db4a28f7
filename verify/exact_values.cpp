#include "verify/exact_values.h"

#include "engine/graph/evaluate.h"
#include "engine/graph/extended.h"

#include <algorithm>

namespace symreal::program {

ExactValues::ExactValues(Graph const &graph) : graph_(graph) { judgement_.outputs.resize(graph.output_count()); }

void ExactValues::begin(std::span<double const> inputs, std::span<double const> parameters) {
  inputs_.assign(inputs.begin(), inputs.end());
  parameters_.assign(parameters.begin(), parameters.end());
  is_evaluated_ = false;
}

std::optional<ExactValues::Point> ExactValues::at(std::vector<double> const &inputs,
                                                  std::vector<double> const &parameters) const {
  std::vector<double> const values = evaluate(graph_, inputs, parameters);
  std::optional<std::vector<long double>> exact = evaluate_extended(graph_, inputs, parameters, values);
  if (!exact) return std::nullopt;
  Point point{{}, std::move(*exact)};
  for (NodeId result : graph_.results) point.in_double.push_back(values[result]);
  return point;
}

void ExactValues::evaluate_call() {
  is_evaluated_ = true;
  point_.reset();
  neighbour_errors_.clear();
  if (judgement_.calls++ == 0) judgement_.obstacle = obstacle_to_extended(graph_);
  if (!judgement_.obstacle.empty()) return;
  point_ = at(inputs_, parameters_);
  if (!point_) ++judgement_.untold;
}

// Neighbours are deterministic.
void ExactValues::look_at_neighbours() {
  neighbour_errors_.assign(graph_.output_count(), 0);
  std::uint64_t random = 1;
  auto move = [&](std::vector<double> numbers) {
    for (double &number : numbers) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      number *= 1 + (static_cast<double>(random >> 11) * 0x1p-52 - 1) * neighbourhood;
    }
    return numbers;
  };
  for (int k = 0; k < neighbours; ++k) {
    std::vector<double> const inputs = move(inputs_), parameters = move(parameters_);
    std::optional<Point> const point = at(inputs, parameters);
    for (std::size_t slot = 0; point && slot < neighbour_errors_.size(); ++slot)
      neighbour_errors_[slot] = std::max(neighbour_errors_[slot], error_of(point->in_double[slot], point->exact[slot]));
  }
}

bool ExactValues::accepts(std::size_t slot, double original, double generated, double tolerance) {
  if (!is_evaluated_) evaluate_call();
  if (!point_ || point_->in_double[slot] != original) return false;
  long double const exact = point_->exact[slot];
  double const generated_error = error_of(generated, exact);
  double original_error = error_of(original, exact);
  if (!is_as_near(generated_error, original_error, tolerance)) {
    if (neighbour_errors_.empty()) look_at_neighbours();
    original_error = std::max(original_error, neighbour_errors_[slot]);
  }
  OutputErrors &errors = judgement_.outputs[slot];
  if (is_as_near(generated_error, original_error, tolerance)) {
    ++errors.calls;
    errors.original = std::max(errors.original, original_error);
    errors.generated = std::max(errors.generated, generated_error);
    return true;
  }
  if (generated_error > errors.failed_generated) {
    errors.failed_original = original_error;
    errors.failed_generated = generated_error;
  }
  return false;
}

} // namespace symreal::program
