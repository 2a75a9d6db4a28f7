// Check of a wrapper: it passes on the generated code's outputs, acts as the original beyond the guards, and notices
// values other than those that the recording has baked in.
#include "program/wrapper/wrapped_original.h"
#include "verify/check.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace symreal::program {
namespace {

constexpr std::size_t most_variations = 40, most_varied = 4; // values, and samples on which each is varied

class Wrapper final : public Check {
public:
  Wrapper(Subject &subject, Verification &result)
      : subject_(subject),
        program_(subject.start("the original with its wrapper", subject.options.wrapper, &subject.code)),
        result_(result) {
    result_.wrapped.resize(subject.graph.output_count());
  }

  bool compare(CheckedSample const &on) override {
    bool is_worst = compare_outputs(result_.wrapped, on.number, on.generated, program_->run(on.sample));
    for (replay::LeftBehind const &left : program_->left_behind())
      if (!contains(on.left_by_generated, left)) add_left(result_.left_by_wrapper, describe(left));
    if (program_->returned() != on.returned) add_left(result_.missed_by_wrapper, "in what it returns besides numbers");
    is_worst |= compare_calls(on);
    if (varied_.size() < most_varied) varied_.push_back(on.sample);
    return is_worst;
  }

  void finish() override {
    program_.reset(); // the variations run the program again
    find_missed_values();
  }

private:
  // Checks later calls, one beyond a guard if possible: the program with the wrapper must act as the original.
  bool compare_calls(CheckedSample const &on) {
    Banner const &banner = subject_.banner;
    bool const has_answer = banner.mode != FloatingPoint::fast && !subject_.in_program && banner.has_values;
    if (!has_answer || tried_calls_ >= most_beyond) return false; // errors propagate, or no evaluator
    ++tried_calls_;
    Replay &original = *subject_.original;
    std::vector<Sample> later;
    if (std::optional<Sample> beyond = subject_.later_calls.beyond_guards(original, on.sample, on.generated))
      later.push_back(std::move(*beyond));
    for (LaterCall &call : subject_.later_calls.inside(original, on.sample, on.generated))
      if (later.size() < Replay::most_later) later.push_back(std::move(call.sample));
    try {
      (void)original.run(on.sample, later, seconds_beyond);
    } catch (DiagnosticError const &) {
      tried_calls_ = most_beyond;
      return false;
    }
    (void)program_->run(on.sample, later);
    bool is_worst = false;
    for (std::size_t call = 1; call < std::min(original.calls(), program_->calls()); ++call) {
      std::vector<double> const inputs = original.next_inputs(later[call - 1], original.outputs_of(call - 1));
      Evaluation const evaluated = evaluate_sample(subject_.graph, inputs, later[call - 1].parameters);
      bool const is_refused = evaluated.failing_guard < subject_.graph.guards.size();
      if (!is_refused && !evaluated.premises.hold_in(banner.mode)) break;
      std::vector<double> const wanted = original.outputs_of(call), found = program_->outputs_of(call);
      for (std::size_t slot = 0; slot < wanted.size(); ++slot) {
        // Beyond a guard the wrapper calls the original; NaNs are equal there.
        bool const is_nan = is_refused && std::isnan(wanted[slot]) && std::isnan(found[slot]);
        if (wanted[slot] != replay::spoilt_output && !is_nan) // the original writes this output
          is_worst |=
              result_.wrapped[slot].add(on.number, wanted[slot], found[slot], banner.mode, subject_.options.tolerance);
      }
    }
    return is_worst;
  }

  using Results = std::vector<std::vector<double>>;

  // Outputs of the program with its wrapper on the varied samples; nullopt if it does not end on one. `wish`: the
  // number of the value to change, negative to call the original in place of the wrapper's statements.
  std::optional<Results> results(std::string const &wish) const {
    wire::Request request;
    request.set(wire::Entry::vary, wish);
    Replay program("the original with its wrapper", subject_.options.wrapper, subject_.run, subject_.recorded.begun_as,
                   subject_.graph, *subject_.front.workspace, &subject_.code, {}, std::move(request));
    Results all;
    try {
      for (Sample const &sample : varied_) all.push_back(program.run(sample));
    } catch (DiagnosticError const &) {
      return std::nullopt;
    }
    return all;
  }

  std::size_t count_different(Results const &original, std::optional<Results> const &other) const {
    std::size_t count = other ? 0 : varied_.size();
    for (std::size_t i = 0; other && i < varied_.size(); ++i)
      count += !all_near(original[i], (*other)[i], subject_.banner.mode, subject_.options.tolerance);
    return count;
  }

  // Changes one baked-in value at a time. Values on which the original does not end are skipped.
  void find_missed_values() {
    std::vector<Variation> const variations = wrapper_variations(subject_.recorded);
    for (std::size_t k = 0; k < std::min(variations.size(), most_variations); ++k) {
      std::string const without = fmt::format("-{}", k + 1);
      std::optional<Results> const original = results(without);
      if (!original) continue;
      std::size_t const different = count_different(*original, results(std::to_string(k + 1)));
      // Reruns the original: memory beyond an extent may hold anything, so its outputs may vary.
      if (different != 0 && count_different(*original, results(without)) == 0)
        result_.missed_by_wrapper.push_back({variations[k].where, different});
    }
  }

  Subject &subject_;
  std::unique_ptr<Replay> program_;
  std::vector<Sample> varied_;
  std::size_t tried_calls_ = 0;
  Verification &result_;
};

} // namespace

std::unique_ptr<Check> check_wrapper(Subject &subject, Verification &result) {
  return !subject.options.wrapper.empty() ? std::make_unique<Wrapper>(subject, result) : nullptr;
}

} // namespace symreal::program
