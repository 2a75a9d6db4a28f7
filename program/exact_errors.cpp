#include "program/exact_errors.h"

#include "graph/evaluate.h"
#include "graph/extended.h"

#include <algorithm>
#include <cmath>

namespace symreal::program {

namespace {

constexpr double most_operations = 4e7; // half a minute in 256 bits

} // namespace

void join(ErrorResult &result, ErrorResult const &other) {
  result.samples += other.samples;
  result.untold += other.untold;
  result.left_out += other.left_out;
  if (result.obstacle.empty()) result.obstacle = other.obstacle;
  for (std::size_t slot = 0; slot < result.outputs.size(); ++slot) {
    ErrorsOfOutput &output = result.outputs[slot];
    ErrorsOfOutput const &more = other.outputs[slot];
    double const before = std::max(output.original, output.generated), now = std::max(more.original, more.generated);
    if (now > before || (now == before && more.worst_sample < output.worst_sample))
      output.worst_sample = more.worst_sample;
    output.original = std::max(output.original, more.original);
    output.generated = std::max(output.generated, more.generated);
    output.original_nearer += more.original_nearer;
    output.generated_nearer += more.generated_nearer;
  }
}

ExactErrors::ExactErrors(Graph const &graph, unsigned bits)
    : graph_(graph),
      outputs_(graph, bits),
      result_{.bits = bits, .obstacle = obstacle_to_extended(graph), .outputs = {}} {
  result_.outputs.resize(graph.output_count());
}

bool ExactErrors::compare(std::size_t sample, std::span<double const> inputs, std::span<double const> parameters,
                          std::span<double const> original, std::span<double const> generated) {
  if (!result_.obstacle.empty()) return false;
  operations_ += static_cast<double>(graph_.nodes.size());
  if (operations_ > most_operations && result_.samples != 0) {
    ++result_.left_out;
    return false;
  }
  auto const all_finite = [](std::span<double const> numbers) {
    return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
  };
  if (!all_finite(original) || !all_finite(generated) ||
      !outputs_.move_to(inputs, parameters, evaluate(graph_, inputs, parameters))) {
    ++result_.untold;
    return false;
  }
  ++result_.samples;
  bool is_worst = false;
  for (std::size_t slot = 0; slot < original.size(); ++slot) {
    ErrorsOfOutput &output = result_.outputs[slot];
    double const before = outputs_.error_of(slot, original[slot]), now = outputs_.error_of(slot, generated[slot]);
    output.original_nearer += before < now;
    output.generated_nearer += now < before;
    if (std::max(before, now) > std::max(output.original, output.generated)) {
      output.worst_sample = sample;
      is_worst = true;
    }
    output.original = std::max(output.original, before);
    output.generated = std::max(output.generated, now);
  }
  return is_worst;
}

} // namespace symreal::program
