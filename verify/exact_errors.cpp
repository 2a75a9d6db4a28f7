#include "verify/exact_errors.h"

#include "engine/graph/evaluate.h"
#include "engine/graph/extended.h"

#include <algorithm>
#include <cmath>

namespace symreal::program {

namespace {

constexpr double most_operations = 4e7; // ten seconds at up to 256 bits; scaled down for more bits

std::string obstacle(Graph const &graph) {
  return calls_program(graph) ? "it calls functions of the program" : obstacle_to_extended(graph);
}

void join(ErrorsOfOutput &output, ErrorsOfOutput const &more) {
  double const before = std::max(output.original, output.generated), now = std::max(more.original, more.generated);
  if (now > before || (now == before && more.worst_sample < output.worst_sample))
    output.worst_sample = more.worst_sample;
  output.original = std::max(output.original, more.original);
  output.generated = std::max(output.generated, more.generated);
  output.original_nearer += more.original_nearer;
  output.generated_nearer += more.generated_nearer;
}

} // namespace

void join(ErrorResult &result, ErrorResult const &other) {
  result.samples += other.samples;
  result.untold += other.untold;
  result.left_out += other.left_out;
  if (result.obstacle.empty()) result.obstacle = other.obstacle;
  for (std::size_t slot = 0; slot < result.outputs.size(); ++slot) join(result.outputs[slot], other.outputs[slot]);
}

ExactErrors::ExactErrors(Graph const &graph, unsigned bits)
    : graph_(graph),
      outputs_(graph, bits),
      result_{.bits = bits, .obstacle = obstacle(graph), .outputs = {}} {
  result_.outputs.resize(graph.output_count());
}

bool ExactErrors::compare(std::size_t k, Sample const &sample, std::span<double const> values,
                          std::span<double const> original, std::span<double const> generated) {
  if (!result_.obstacle.empty()) return false;
  operations_ += static_cast<double>(graph_.nodes.size()) * std::max(1.0, result_.bits / 256.0);
  if (operations_ > most_operations) {
    ++result_.left_out;
    return false;
  }
  auto const all_finite = [](std::span<double const> numbers) {
    return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
  };
  if (!all_finite(original) || !all_finite(generated) || !outputs_.move_to(sample.inputs, sample.parameters, values)) {
    ++result_.untold;
    return false;
  }
  ++result_.samples;
  bool is_worst = false;
  for (std::size_t slot = 0; slot < original.size(); ++slot) {
    double const before = outputs_.error_of(slot, original[slot]), now = outputs_.error_of(slot, generated[slot]);
    ErrorsOfOutput &output = result_.outputs[slot];
    join(output, {before, now, before < now, now < before, k});
    is_worst |= output.has_worst() && output.worst_sample == k;
  }
  return is_worst;
}

} // namespace symreal::program
