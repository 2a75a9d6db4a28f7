#include "verify/exact_errors.h"

#include "engine/graph/evaluate.h"
#include "engine/graph/extended.h"
#include "verify/check.h"

#include <algorithm>
#include <cmath>

// Functions of Multiprecision are found by argument-dependent lookup.
#define SYMREAL_MATH(function) function
#include "engine/graph/evaluate_in.h"

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

Multiprecision evaluate_exact(Op op, Multiprecision const &x, Multiprecision const &y, Multiprecision const &z) {
  return evaluate_in(op, x, y, z);
}

ExactOutputs::ExactOutputs(Graph const &graph, unsigned bits) : graph_(graph) { Multiprecision::set_bits(bits); }

bool ExactOutputs::move_to(std::span<double const> inputs, std::span<double const> parameters,
                           std::span<double const> values) {
  auto const leaf = [&](NodeId, Node const &node, std::vector<Multiprecision> const &) {
    return Multiprecision(node.op == Op::input ? inputs[node.slot()] : parameters[node.slot()]);
  };
  auto wide = evaluate_nodes<Multiprecision>(graph_, values, leaf, [](NodeId, Multiprecision const &) {});
  if (!wide) return false;
  outputs_.clear();
  for (NodeId result : graph_.results) outputs_.push_back((*wide)[result]);
  return true;
}

double ExactOutputs::error_of(std::size_t slot, double number) const {
  Multiprecision const &exact = outputs_[slot];
  return static_cast<double>(fabs(Multiprecision(number) - exact) / fmax(fabs(exact), Multiprecision(1)));
}

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

namespace {

class Errors final : public Check {
public:
  Errors(Subject &subject, Verification &result)
      : errors_(subject.graph, subject.options.exact_bits),
        result_(result) {}

  bool compare(CheckedSample const &on) override {
    bool const is_worst = errors_.compare(on.number, on.sample, on.values, on.original, on.generated);
    if (is_worst) result_.errors = errors_.result();
    return is_worst;
  }

  void finish() override { result_.errors = errors_.result(); }

private:
  ExactErrors errors_;
  Verification &result_;
};

} // namespace

std::unique_ptr<Check> check_exact_errors(Subject &subject, Verification &result) {
  return subject.options.exact_bits != 0 ? std::make_unique<Errors>(subject, result) : nullptr;
}

} // namespace symreal::program
