#include "verify/later_calls.h"

#include "verify/check.h"

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

namespace {

class CallsInARow final : public Check {
public:
  CallsInARow(Subject &subject, Verification &result) : subject_(subject), result_(result) {}

  bool compare(CheckedSample const &on) override {
    bool is_worst = compare_later(on);
    if (!on.later.empty() && tried_beyond_ < most_beyond) is_worst |= compare_beyond(on);
    return is_worst;
  }

private:
  // Compares later calls, each on the state that the original leaves. In mode fast, a difference counts only if the
  // original would give another output in a first call: rounding is judged by first calls.
  bool compare_later(CheckedSample const &on) {
    Replay &program = *subject_.original;
    FloatingPoint const mode = subject_.banner.mode;
    double const tolerance = subject_.options.tolerance;
    std::vector<std::pair<LaterCall, std::vector<double>>> calls; // and the original's outputs
    for (std::size_t call = 1; call < program.calls(); ++call) {
      LaterCall const &plan = on.later[call - 1];
      std::vector<double> const before = program.outputs_of(call - 1);
      bool const as_planned = program.next_inputs(plan.sample, before) == plan.sample.inputs;
      std::optional<LaterCall> now = as_planned ? plan : subject_.later_calls.after(program, plan.sample, before);
      if (!now) break;
      calls.emplace_back(std::move(*now), program.outputs_of(call));
    }
    bool is_worst = false;
    for (auto const &[call, original] : calls) {
      bool const may_round = mode == FloatingPoint::fast && !all_near(original, call.outputs, mode, tolerance);
      if (may_round && all_same(program.run(call.sample), original)) continue;
      is_worst |= compare_outputs(result_.called_again, on.number, original, call.outputs, mode, tolerance);
    }
    return is_worst;
  }

  // Compares the original beyond a guard, after calls of the generated code that it has not seen: it must not need
  // state from them. Failing or not ending beyond the guards says nothing.
  bool compare_beyond(CheckedSample const &on) {
    Replay &program = *subject_.original;
    std::optional<Sample> const beyond = subject_.later_calls.beyond_guards(program, on.sample, on.generated);
    if (!beyond) return false;
    ++tried_beyond_;
    bool is_worst = false;
    // The state that code of another mode than strict leaves may have zeros of another sign.
    bool const is_strict = subject_.banner.mode == FloatingPoint::strict;
    try {
      std::vector<double> const alone = program.run(*beyond, {}, seconds_beyond);
      (void)program.run(on.sample, {&*beyond, 1}, seconds_beyond);
      if (program.calls() < 2) return false;
      std::vector<double> const after = program.outputs_of(1);
      for (std::size_t slot = 0; slot < alone.size(); ++slot)
        if (after[slot] != replay::spoilt_output && (is_strict || after[slot] != alone[slot])) // the original writes it
          is_worst |= result_.called_beyond[slot].add(on.number, after[slot], alone[slot], FloatingPoint::strict, 0);
    } catch (DiagnosticError const &) {
      tried_beyond_ = most_beyond;
    }
    return is_worst;
  }

  Subject &subject_;
  std::size_t tried_beyond_ = 0;
  Verification &result_;
};

} // namespace

std::unique_ptr<Check> check_later_calls(Subject &subject, Verification &result) {
  result.called_again.resize(subject.graph.output_count());
  result.called_beyond.resize(subject.graph.output_count());
  return std::make_unique<CallsInARow>(subject, result);
}

} // namespace symreal::program
