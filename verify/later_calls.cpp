#include "verify/later_calls.h"

#include <bit>

namespace symreal::program {

namespace {

constexpr int most_draws = 6; // draws per call

} // namespace

// Seed that depends on the sample alone, so that a replayed sample gets the same later calls.
std::uint64_t LaterCalls::seed_of(Sample const &first) const {
  std::uint64_t hash = seed_;
  for (std::vector<double> const *numbers : {&first.inputs, &first.parameters})
    for (double number : *numbers) hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001b3;
  return hash;
}

std::optional<LaterCall> LaterCalls::after(Replay const &original, Sample sample,
                                           std::span<double const> outputs) const {
  sample.inputs = original.next_inputs(sample, outputs);
  Evaluation const evaluated = evaluate_sample(graph_, sample.inputs, sample.parameters);
  if (!evaluated.premises.hold_in(mode_) || evaluated.failing_guard < graph_.guards.size()) return std::nullopt;
  GeneratedCode::Result computed = run_(sample);
  if (computed.failed != 0) return std::nullopt;
  return LaterCall{std::move(sample), std::move(computed.outputs)};
}

std::vector<LaterCall> LaterCalls::inside(Replay const &original, Sample const &first,
                                          std::span<double const> outputs) const {
  SampleSource source(graph_, seed_of(first));
  (void)source.next(); // skips the recorded sample
  std::vector<LaterCall> calls;
  for (int draw = 0; draw < most_draws && calls.size() < Replay::most_later; ++draw) {
    // The last draw reuses the first sample, which may lie inside if no drawn sample does.
    std::optional<LaterCall> next = after(original, draw + 1 < most_draws ? source.next() : first, outputs);
    if (!next) continue;
    calls.push_back(std::move(*next));
    outputs = calls.back().outputs;
  }
  return calls;
}

std::optional<Sample> LaterCalls::beyond_guards(Replay const &original, Sample const &first,
                                                std::span<double const> outputs) const {
  if (graph_.guards.empty()) return std::nullopt;
  SampleSource source(graph_, seed_of(first) + 1);
  for (int draw = 0; draw < most_draws; ++draw) {
    Sample next = source.next();
    next.inputs = original.next_inputs(next, outputs);
    Evaluation const evaluated = evaluate_sample(graph_, next.inputs, next.parameters);
    if (evaluated.premises.defined && evaluated.failing_guard < graph_.guards.size()) return next;
  }
  return std::nullopt;
}

} // namespace symreal::program
