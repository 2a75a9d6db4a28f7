#include "verify/verification.h"

#include "engine/emit/origins/origins.h"
#include "engine/graph/evaluate.h"
#include "engine/optimise/differentiate/differentiate.h"
#include "engine/support/math_library.h"
#include "engine/support/progress.h"
#include "runtime/replay/boundaries.h"
#include "verify/check.h"

#include <algorithm>
#include <bit>
#include <fmt/format.h>

namespace symreal::program {

std::size_t count_different(std::vector<OutputComparison> const &outputs) {
  return static_cast<std::size_t>(std::count_if(outputs.begin(), outputs.end(),
                                                [](OutputComparison const &output) { return output.different != 0; }));
}

Recorded const &require_match(std::vector<Recorded> const &kernels, Banner const &banner, std::string const &path) {
  auto found = std::find_if(kernels.begin(), kernels.end(),
                            [&](Recorded const &kernel) { return kernel.graph.kernel == banner.kernel; });
  if (found == kernels.end())
    fail(DiagnosticId::foreign_file, {path, 1, 1}, "the sources have no kernel '" + banner.kernel + "'");
  Graph const &graph = found->graph;
  std::optional<Graph> differentiated;
  if (!banner.derivatives.empty()) differentiated = differentiate(graph, banner.derivatives, [](Diagnostic const &) {});
  Graph const &with = differentiated ? *differentiated : graph;
  if (with.input_count() != banner.inputs || with.parameter_count() != banner.parameters ||
      with.output_count() - (banner.has_values ? 0 : graph.output_count()) != banner.outputs)
    fail(DiagnosticId::foreign_file, {path, 1, 1},
         fmt::format("kernel '{}' has {} inputs, {} parameters and {} outputs, the file {}, {} and {}", banner.kernel,
                     with.input_count(), with.parameter_count(), with.output_count(), banner.inputs, banner.parameters,
                     banner.outputs));
  return *found;
}

namespace {

bool is_untouched(std::vector<double> const &outputs) {
  return std::all_of(outputs.begin(), outputs.end(),
                     [](double value) { return std::bit_cast<std::uint64_t>(value) == GeneratedCode::untouched; });
}

// Does the code's guard, as guard_text of emit writes it, have the text of this guard of the graph? A part of its
// text may be the text of another guard.
bool is_text_of(GuardCheck const &check, Guard const &guard) {
  std::string_view const text = check.text;
  for (std::size_t at = text.find(guard.text); at != text.npos; at = text.find(guard.text, at + 1)) {
    std::string_view const before = text.substr(0, at), after = text.substr(at + guard.text.size());
    if ((before.empty() || before.ends_with(": ")) && (after.empty() || after.starts_with(", in "))) return true;
  }
  return false;
}

// May the code return this guard if `failing` is the graph's first guard that does not hold?
bool is_expected(Graph const &graph, std::size_t failing, GuardCheck const &returned,
                 std::vector<GuardCheck> const &guards) {
  if (is_text_of(returned, graph.guards[failing])) return true;
  for (GuardCheck const &other : guards)
    if (is_text_of(other, graph.guards[failing])) return false; // the code has that guard
  for (std::size_t k = failing + 1; k < graph.guards.size(); ++k)
    if (is_text_of(returned, graph.guards[k])) return true;
  return false;
}

// Checks the guard that the code returned. `failing`: the first guard of the recorded graph that does not hold, or the
// number of guards if all hold. The code may lack a guard that follows from others; then a later guard of the graph may
// fail in its place. Counts mismatches and keeps the first.
void check_guards(Graph const &graph, std::size_t failing, GeneratedCode::Result const &result, std::size_t sample,
                  Verification &verification) {
  bool const should_fail = failing < graph.guards.size();
  auto mismatch = [&](std::string found) {
    if (verification.guards_different++ == 0)
      verification.guard_mismatch = {sample, should_fail ? graph.guards[failing].text : "", std::move(found)};
  };
  verification.refused += should_fail;
  if (result.failed == 0) {
    if (should_fail) mismatch("no guard");
    return;
  }
  auto const number = static_cast<std::size_t>(result.failed) - 1;
  if (result.failed < 0 || number >= verification.guards.size())
    return mismatch("guard " + std::to_string(result.failed));
  GuardCheck &guard = verification.guards[number];
  if (!should_fail || !is_expected(graph, failing, guard, verification.guards))
    return mismatch("guard " + std::to_string(result.failed) + ", " + guard.text);
  ++guard.failed;
  if (!is_untouched(result.outputs)) mismatch("that guard, but wrote to its outputs");
}

// In the order in which they see a sample: the first ones read what the original's run left, later ones run it again.
constexpr MakeCheck *all_checks[] = {check_derivatives, check_threads,       check_left_state,   check_outputs,
                                     check_later_calls, check_next_call,     check_rewritten,    check_own_flags,
                                     check_wrapper,     check_unnamed_state, check_exact_errors, check_branches};

class Verifier {
public:
  explicit Verifier(Subject &subject)
      : subject_(subject),
        options_(subject.options),
        banner_(subject.banner),
        graph_(subject.graph),
        source_(graph_, options_.seed),
        decisions_(counts_decisions() ? decisions_of(graph_) : std::vector<symreal::Decision>()) {
    result_.mode = banner_.mode;
    result_.is_single = banner_.is_single;
    result_.has_values = banner_.has_values;
    result_.tolerance = options_.tolerance;
    result_.mathematics = math_library();
    for (std::size_t number = 1; number <= banner_.guards; ++number)
      result_.guards.push_back({subject.code.guard_text(number)});
    for (symreal::Decision const &decision : decisions_)
      result_.decisions.push_back({place_of(decision), decision.is_guards, {}});
    for (MakeCheck *const make : all_checks)
      if (std::unique_ptr<Check> check = make(subject, result_)) checks_.push_back(std::move(check));
  }

  Verification run() {
    if (options_.replayed.empty()) {
      try_drawn();
      Boundaries const boundaries = find_boundaries(graph_, options_.seed, subject_.is_exact() ? 0 : least_apart);
      result_.crossed = boundaries.crossed;
      Progress progress("samples around decisions", boundaries.samples.size());
      for (std::size_t k = 0; k < boundaries.samples.size(); ++k) {
        result_.around += options_.shard.has(options_.samples + k);
        try_sample(options_.samples + k, boundaries.samples[k]);
        progress.add();
      }
      std::size_t const drawn = options_.samples + boundaries.samples.size();
      for (std::size_t k = 0; k < options_.given.size(); ++k) try_sample(drawn + k, options_.given[k]);
    }
    for (std::size_t k = 0; k < options_.replayed.size(); ++k) try_sample(k, options_.replayed[k]);
    keep_named();
    for (std::unique_ptr<Check> &check : checks_) check->finish();
    return std::move(result_);
  }

private:
  // Decisions are not counted if the graph is evaluated in another process or the user chose the samples.
  bool counts_decisions() const { return !subject_.in_program && options_.replayed.empty(); }

  // Place of a decision, in words.
  std::string place_of(symreal::Decision const &decision) const {
    std::string const place = decision.location == no_location ? "" : describe_locations(graph_, {decision.location});
    return place.empty() ? "where no place is known" : place;
  }

  void try_drawn() {
    Progress progress("samples", options_.samples);
    for (std::size_t k = 0; k < options_.samples; ++k) {
      try_sample(k, source_.next());
      progress.add();
    }
  }

  void try_sample(std::size_t k, Sample const &drawn) {
    if (!options_.shard.has(k)) return;
    ++result_.tried;
    is_named_ = false;
    Sample const sample = banner_.is_single ? in_single_precision(drawn) : drawn;
    compare(k, sample);
    if (!is_named_) return;
    result_.named[k] = sample;
    if (result_.named.size() > 2 * most_named_) keep_named();
  }

  // Drops samples that are no longer the worst of any output.
  void keep_named() {
    std::map<std::size_t, Sample> kept;
    auto const keep = [&](std::size_t k) {
      if (auto const found = result_.named.find(k); found != result_.named.end()) kept.insert(*found);
    };
    for (auto const *outputs :
         {&result_.outputs, &result_.rewritten, &result_.called_again, &result_.called_beyond, &result_.wrapped})
      for (OutputComparison const &output : *outputs)
        if (output.has_worst()) keep(output.worst_sample);
    if (result_.errors)
      for (ErrorsOfOutput const &output : result_.errors->outputs)
        if (output.has_worst()) keep(output.worst_sample);
    if (result_.guard_mismatch) keep(result_.guard_mismatch->sample);
    result_.named = std::move(kept);
    most_named_ = std::max<std::size_t>(least_named, result_.named.size());
  }

  Evaluation evaluate_recorded(Sample const &sample) {
    if (subject_.in_program) return subject_.original->run_graph(sample);
    values_ = evaluate(graph_, sample.inputs, sample.parameters);
    return evaluation_of(graph_, values_);
  }

  void count_decisions() {
    if (decisions_.empty()) return;
    std::vector<char> const active = active_nodes(graph_, values_);
    for (std::size_t k = 0; k < decisions_.size(); ++k) {
      DecisionCounts &counts = result_.decisions[k].counts;
      if (active[decisions_[k].condition]) ++(values_[decisions_[k].condition] != 0 ? counts.yes : counts.no);
    }
  }

  void compare(std::size_t k, Sample const &sample) {
    Replay &program = *subject_.original;
    bool const in_program = subject_.in_program;
    Evaluation const evaluated = evaluate_recorded(sample);
    std::vector<double> const inputs = subject_.with_seeds(sample.inputs);
    GeneratedCode::Result const computed =
        in_program ? program.run_generated(sample, inputs) : subject_.code.run(inputs, sample.parameters);
    // State left by the functions that the generated code calls; the original's functions leave the same.
    std::vector<replay::LeftBehind> const left_by_generated =
        in_program ? program.left_behind() : std::vector<replay::LeftBehind>();
    for (std::unique_ptr<Check> &check : checks_) check->see(sample, computed);
    std::optional<SingleRuns> single;
    if (banner_.is_single) single.emplace(graph_, sample);
    Premises const premises = single && evaluated.premises.hold() ? single->premises() : evaluated.premises;
    bool const inside = premises.hold_in(banner_.is_single ? FloatingPoint::finite : banner_.mode);
    if (!premises.defined)
      ++result_.undefined;
    else if (!inside)
      ++(premises.finite ? result_.zero_sign : result_.not_finite);
    if (inside && single && single->decide_otherwise(evaluated.failing_guard)) return void(++result_.decided_otherwise);
    if (inside) {
      count_decisions();
      check_guards(graph_, evaluated.failing_guard, computed, k, result_);
      is_named_ |= result_.guard_mismatch && result_.guard_mismatch->sample == k;
    }
    // Beyond a guard the original takes an unrecorded path, where nothing is promised.
    if (evaluated.failing_guard < graph_.guards.size() || computed.failed != 0 || !premises.defined) return;
    bool const is_called_again = inside && !in_program && !single && banner_.has_values;
    std::vector<LaterCall> const later =
        is_called_again ? plan_later(sample, computed.outputs) : std::vector<LaterCall>();
    std::vector<double> const original = run_original(sample, later);
    // Code with derivatives alone has no values to compare.
    std::size_t const values = banner_.has_values ? original.size() : 0;
    std::span<double const> const outputs = computed.outputs;
    std::vector<double> const generated =
        banner_.has_values ? std::vector(outputs.begin(), outputs.begin() + static_cast<std::ptrdiff_t>(values))
                           : original;
    if (!inside) {
      FloatingPoint const mode = banner_.is_single ? FloatingPoint::fast : FloatingPoint::strict;
      result_.outside_different += !all_near(original, generated, mode, options_.tolerance);
      return;
    }
    CheckedSample const checked = {
        k,       sample, original,           generated,         outputs.subspan(values),    evaluated.outputs,
        values_, later,  program.returned(), left_by_generated, single ? &*single : nullptr};
    for (std::unique_ptr<Check> &check : checks_) is_named_ |= check->compare(checked);
    ++result_.inside;
  }

  std::vector<LaterCall> plan_later(Sample const &sample, std::vector<double> const &generated) {
    if (!subject_.original->has_run()) (void)subject_.original->run(sample); // a run tells which inputs are state
    return subject_.later_calls.inside(*subject_.original, sample, generated);
  }

  std::vector<double> run_original(Sample const &sample, std::vector<LaterCall> const &later) {
    std::vector<Sample> samples;
    for (LaterCall const &call : later) samples.push_back(call.sample);
    return subject_.original->run(sample, samples);
  }

  Subject &subject_;
  VerificationOptions const &options_;
  Banner const &banner_;
  Graph const &graph_;
  SampleSource source_;
  std::vector<symreal::Decision> decisions_;
  std::vector<double> values_; // of the recorded graph, at the current sample
  static constexpr std::size_t least_named = 1000;
  static constexpr double least_apart = 0x1p-20; // distance of samples on both sides of a boundary that rounding moves
  std::size_t most_named_ = least_named;
  bool is_named_ = false; // a result refers to the current sample
  Verification result_;
  std::vector<std::unique_ptr<Check>> checks_;
};

} // namespace

Verification verify(Front const &front, RunOptions const &run, Recorded const &recorded, std::string const &path,
                    Banner const &banner, VerificationOptions const &options) {
  Subject subject(front, run, recorded, path, banner, options);
  return Verifier(subject).run();
}

} // namespace symreal::program
