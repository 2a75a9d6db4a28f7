#include "verify/verification.h"

#include "engine/emit/origins/origins.h"
#include "engine/graph/evaluate.h"
#include "engine/graph/implicit.h"
#include "engine/optimise/differentiate/calls.h"
#include "engine/optimise/differentiate/differentiate.h"
#include "engine/support/math_library.h"
#include "engine/support/progress.h"
#include "program/record/symbolize.h"
#include "program/wrapper/wrapped_original.h"
#include "runtime/memory/static_objects.h"
#include "runtime/replay/boundaries.h"
#include "verify/guard_verification.h"
#include "verify/later_calls.h"
#include "verify/next_call.h"
#include "verify/replay.h"
#include "verify/single_runs.h"
#include "verify/wrapper_verification.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <llvm/Demangle/Demangle.h>
#include <memory>

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

// Description of an object that is left changed. Objects on the stack and the heap are told apart by place only.
std::string describe(replay::LeftBehind const &left) {
  switch (left.region) {
  case memory::Region::static_object: return "'" + llvm::demangle(left.name) + "'";
  case memory::Region::heap_block: return fmt::format("a block of {} bytes on the heap", left.size);
  case memory::Region::stack: return "a variable of a calling function";
  }
  return {};
}

// Source name of a function's static variable; empty if the linker's name denotes something else.
std::string local_name(std::string const &linker_name) {
  if (linker_name.starts_with("_ZZ")) {
    std::string const name = llvm::demangle(linker_name);
    std::size_t const scope = name.rfind("::");
    return scope == name.npos ? "" : name.substr(scope + 2);
  }
  std::string const name = memory::name_in_c(linker_name);
  return name == linker_name ? "" : name;
}

class Verifier {
public:
  Verifier(Front const &front, RunOptions const &run, Recorded const &recorded, std::string const &path,
           Banner const &banner, VerificationOptions const &options)
      : front_(front),
        run_(run),
        recorded_(recorded),
        options_(options),
        completed_(with_derivative_functions(recorded.graph, banner)),
        graph_(completed_ ? *completed_ : recorded.graph),
        scratch_(recorded.scratch),
        annotated_(front.annotated),
        kernel_(recorded.kernel),
        banner_(banner),
        code_(path, banner, graph_, {}, *front.workspace),
        source_(graph_, options.seed),
        later_calls_(graph_, banner.mode, options.seed,
                     [this](Sample const &sample) { return code_.run(with_seeds(sample.inputs), sample.parameters); }),
        exact_(graph_),
        symbolizer_(front.original_program.empty() ? front.replay_program : front.original_program, *front.overlay),
        decisions_(counts_decisions() ? decisions_of(graph_) : std::vector<symreal::Decision>()) {
    bool const by_hand = front.original_program.empty();
    std::string const changeable = front.workspace->file("changeable");
    std::ofstream(changeable) << fmt::format("{}\n", fmt::join(front.rewritten.changeable, "\n"));
    auto const start = [&](std::unique_ptr<Replay> &program, char const *what, std::string const &executable,
                           GeneratedCode const *code, std::string const &profile = {}) {
      std::vector<std::string> environment;
      std::string const &others = recorded.kernel.signature.redefinition.result.others;
      if (options.wrapper && !others.empty()) environment.push_back("SYMREAL_RETURNED=" + others);
      environment.push_back("SYMREAL_CHANGEABLE=" + changeable);
      program = std::make_unique<Replay>(what, executable, run, recorded.begun_as, graph_, *front.workspace, code,
                                         profile, environment);
    };
    start(original_, "the original", by_hand ? front.replay_program : front.original_program,
          code_.needs_program() ? &code_ : nullptr);
    if (!banner.derivatives.empty())
      derivatives_.emplace(graph_, recorded.graph, path, banner, derivative_tolerance(), program_calls());
    if (!by_hand && !front.replay_program.empty())
      start(rewritten_, "the rewritten program", front.replay_program, nullptr);
    if (!front.own_flags_program.empty() && !banner.is_single)
      start(own_flags_, "the original with its own flags", front.own_flags_program, nullptr);
    if (banner.threads > 1)
      threads_.emplace(path, banner, graph_, *front.workspace,
                       [&](std::unique_ptr<Replay> &program, GeneratedCode const &code) {
                         start(program, "the original", by_hand ? front.replay_program : front.original_program, &code);
                       });
    asks_next_call_ = !by_hand && !code_.needs_program() && !banner.is_single && banner.has_values &&
                      banner.derivatives.empty() && banner.mode != FloatingPoint::fast && !options.branches &&
                      is_next_call_comparable(recorded);
    if (options.wrapper) {
      wrapped_program_ = build_wrapped(front, recorded);
      start(wrapped_, "the original with its wrapper", wrapped_program_, &code_);
      result_.wrapped.resize(graph_.output_count());
    }
    if (options.branches) {
      result_.branches = BranchResult{front.covered.obstacle, {}};
      covered_run_ = {front.covered.path, front.workspace->file("branches"), {}, 0};
      if (!front.covered.path.empty())
        start(covered_, "the original that counts its branches", front.covered.path, nullptr, covered_run_.profile);
    }
    if (options.exact_bits != 0) errors_.emplace(graph_, options.exact_bits);
    result_.mode = banner.mode;
    result_.is_single = banner.is_single;
    result_.has_values = banner.has_values;
    result_.tolerance = options.tolerance;
    result_.mathematics = math_library();
    result_.lost.resize(graph_.output_count());
    result_.outputs.resize(graph_.output_count());
    result_.rewritten.resize(graph_.output_count());
    result_.called_again.resize(graph_.output_count());
    result_.called_beyond.resize(graph_.output_count());
    for (std::size_t number = 1; number <= banner.guards; ++number)
      result_.guards.push_back({code_.guard_text(number)});
    if (own_flags_) result_.own_flags_ulp.resize(graph_.output_count());
    if (own_flags_ && !front.own_flags.empty() && !code_.needs_program() && banner.has_values)
      compile_with_own_flags(front, path);
  }

  Verification run() {
    for (symreal::Decision const &decision : decisions_)
      result_.decisions.push_back({place_of(decision), decision.is_guards, {}});
    if (options_.replayed.empty()) {
      try_drawn();
      Boundaries const boundaries = find_boundaries(graph_, options_.seed, is_exact() ? 0 : least_apart);
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
    if (threads_) result_.threads = threads_->finish(code_, timed_ ? &*timed_ : nullptr);
    result_.exact = exact_.judgement();
    if (errors_) result_.errors = errors_->result();
    if (derivatives_) result_.derivatives = derivatives_->result();
    if (covered_) finish_branches();
    if (!tried_next_.empty())
      result_.next_call_different = different_in_next_call(front_, run_, recorded_, code_, *original_,
                                                           front_.original_program, tried_next_, options_.tolerance);
    if (wrapped_) {
      wrapped_.reset();
      for (LeftState &one : values_missed_by_wrapper(front_, run_, recorded_, graph_, code_, wrapped_program_,
                                                     tried_wrapped_, options_.tolerance))
        result_.missed_by_wrapper.push_back(std::move(one));
    }
    return std::move(result_);
  }

private:
  // Decisions are not counted if the graph is evaluated in another process or the user chose the samples.
  bool counts_decisions() const { return !code_.needs_program() && options_.replayed.empty(); }

  // Does the code decide exactly as the original does? Otherwise rounding moves the decision boundaries.
  bool is_exact() const { return banner_.mode != FloatingPoint::fast && !banner_.is_single; }

  // Tolerance of derivatives: the usual one in modes that promise equal numbers, as the original has no derivatives.
  double derivative_tolerance() const {
    return banner_.mode == FloatingPoint::fast ? options_.tolerance : VerificationOptions().tolerance;
  }

  // The graph completed by the functions that dual numbers and derivative formulas call; nullopt if it needs none.
  static std::optional<Graph> with_derivative_functions(Graph const &graph, Banner const &banner) {
    bool const has_implicit = std::ranges::any_of(graph.externals, is_implicit);
    if (!has_implicit && (banner.derivatives.empty() || !calls_program(graph))) return std::nullopt;
    std::optional<Graph> completed(without_implicit(graph));
    if (!banner.derivatives.empty()) add_derivative_functions(*completed);
    return completed;
  }

  CallExternal program_calls() const {
    if (!code_.needs_program()) return {};
    return [program = original_.get()](std::size_t function, std::span<double const> arguments,
                                       std::span<double> results) { program->call(function, arguments, results); };
  }

  std::vector<double> with_seeds(std::vector<double> const &inputs) const {
    return derivatives_ ? derivatives_->with_seeds(inputs) : inputs;
  }

  // Compiles the generated code as the user's project would.
  void compile_with_own_flags(Front const &front, std::string const &path) {
    std::vector<char const *> words;
    for (std::string const &flag : front.own_flags) words.push_back(flag.c_str());
    own_code_.emplace(path, banner_, graph_,
                      CodeBuild{front.build.c_compiler, front.build.compiler, words, "generated-own-flags.so"},
                      *front.workspace);
    result_.own_code_ulp.resize(graph_.output_count());
  }

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
    if (errors_)
      for (ErrorsOfOutput const &output : errors_->result().outputs)
        if (output.has_worst()) keep(output.worst_sample);
    if (result_.guard_mismatch) keep(result_.guard_mismatch->sample);
    result_.named = std::move(kept);
    most_named_ = std::max<std::size_t>(least_named, result_.named.size());
  }

  Evaluation evaluate_recorded(Sample const &sample) {
    if (code_.needs_program()) return original_->run_graph(sample);
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
    bool const in_program = code_.needs_program();
    Evaluation const evaluated = evaluate_recorded(sample);
    GeneratedCode::Result const computed = in_program ? original_->run_generated(sample, with_seeds(sample.inputs))
                                                      : code_.run(with_seeds(sample.inputs), sample.parameters);
    // State left by the functions that the generated code calls; the original's functions leave the same.
    left_by_generated_ = in_program ? original_->left_behind() : std::vector<replay::LeftBehind>();
    if (threads_) threads_->compare({with_seeds(sample.inputs), sample.parameters}, computed);
    if (banner_.is_single) single_.emplace(graph_, sample);
    Premises const premises = single_ && evaluated.premises.hold() ? single_->premises() : evaluated.premises;
    bool const inside = premises.hold_in(banner_.is_single ? FloatingPoint::finite : banner_.mode);
    if (!premises.defined)
      ++result_.undefined;
    else if (!inside)
      ++(premises.finite ? result_.zero_sign : result_.not_finite);
    if (inside && single_ && single_->decide_otherwise(evaluated.failing_guard))
      return void(++result_.decided_otherwise);
    if (inside) {
      count_decisions();
      check_guards(graph_, evaluated.failing_guard, computed, k, result_);
      is_named_ |= result_.guard_mismatch && result_.guard_mismatch->sample == k;
    }
    // Beyond a guard the original takes an unrecorded path, where nothing is promised.
    if (evaluated.failing_guard < graph_.guards.size() || computed.failed != 0 || !premises.defined) return;
    bool const is_called_again = inside && !in_program && !single_ && banner_.has_values;
    std::vector<LaterCall> const later =
        is_called_again ? plan_later(sample, computed.outputs) : std::vector<LaterCall>();
    std::vector<double> const original = run_original(sample, later);
    returned_ = original_->returned();
    // Code with derivatives alone has no values to compare.
    std::size_t const values = banner_.has_values ? original.size() : 0;
    std::vector<double> const generated =
        banner_.has_values
            ? std::vector(computed.outputs.begin(), computed.outputs.begin() + static_cast<std::ptrdiff_t>(values))
            : original;
    if (inside)
      compare_inside(k, sample, original, generated, evaluated.outputs, later);
    else
      result_.outside_different += !(banner_.is_single ? all_near(original, generated) : all_same(original, generated));
    if (inside && errors_) is_named_ |= errors_->compare(k, sample, values_, original, generated);
    if (inside && covered_) count_branches(sample);
    if (inside && derivatives_)
      derivatives_->compare(sample, std::span<double const>(computed.outputs).subspan(values));
    if (inside && !timed_) timed_ = {with_seeds(sample.inputs), sample.parameters};
    result_.inside += inside;
  }

  // Counts branches. A sample on which the counting build does not end says nothing about the generated code.
  void count_branches(Sample const &sample) {
    try {
      covered_->run(sample);
      ++covered_run_.samples;
    } catch (DiagnosticError const &error) {
      result_.branches->obstacle = error.diagnostic().message;
      covered_.reset();
    }
  }

  void finish_branches() {
    covered_run_.stack = covered_->stack();
    covered_.reset(); // the program writes the counts when it ends
    result_.branches = read_branches(covered_run_, annotated_, kernel_);
  }

  void compare_inside(std::size_t k, Sample const &sample, std::vector<double> const &original,
                      std::vector<double> const &generated, std::vector<double> const &recorded,
                      std::vector<LaterCall> const &later) {
    for (replay::LeftBehind const &left : original_->left_behind())
      if (!is_left_by_generated(left) && !is_scratch(left)) add_left(result_.left, describe(left));
    if (!code_.needs_program())
      for (replay::OutsideEffect const &effect : original_->effects()) add_outside(effect);
    exact_.begin(sample.inputs, sample.parameters);
    for (std::size_t slot = 0; slot < original.size(); ++slot) {
      if (!single_)
        add(result_.outputs[slot], k, slot, original[slot], generated[slot]);
      else if (single_->lose(slot, original[slot], options_.tolerance))
        ++result_.lost[slot];
      else
        is_named_ |= result_.outputs[slot].add_single(k, original[slot], generated[slot], options_.tolerance);
    }
    compare_later(k, later);
    if (asks_next_call_ && tried_next_.size() < most_varied) tried_next_.push_back(sample);
    if (!later.empty() && tried_beyond_ < most_beyond) compare_beyond(k, sample, generated);
    result_.graph_different += !all_same(original, recorded);
    if (rewritten_) {
      std::vector<double> const rewritten = rewritten_->run(sample);
      for (std::size_t slot = 0; slot < original.size(); ++slot)
        is_named_ |= result_.rewritten[slot].add(k, original[slot], rewritten[slot], FloatingPoint::strict, 0);
    }
    if (own_flags_) keep_worst(result_.own_flags_ulp, own_flags_->run(sample), generated);
    if (wrapped_) compare_wrapper(k, sample, generated);
    if (own_code_)
      keep_worst(result_.own_code_ulp, original, own_code_->run(with_seeds(sample.inputs), sample.parameters).outputs);
    if (!code_.needs_program() && examined_ < most_examined) examine(sample); // last, as it runs the original again
  }

  void examine(Sample const &sample) {
    ++examined_;
    std::vector<replay::UnnamedObject> const found = original_->examine(sample);
    if (result_.unexamined.empty()) result_.unexamined = original_->unexamined();
    for (replay::UnnamedObject const &one : found) {
      if (is_scratch(one.object)) continue;
      std::vector<Frame> const frames = symbolizer_.frames({one.instruction + 1});
      std::string const place = frames.empty() ? "" : " (" + to_string(frames.front().place) + ")";
      if (one.is_read == 0)
        add_left(result_.overwritten, describe(one.object) + place);
      else if (graph_.frozen.empty()) // otherwise frozen state was accepted by the user
        add_left(result_.unnamed, describe(one.object) + place);
    }
  }

  std::vector<LaterCall> plan_later(Sample const &sample, std::vector<double> const &generated) {
    if (!original_->has_run()) (void)original_->run(sample); // a run tells which inputs are state
    return later_calls_.inside(*original_, sample, generated);
  }

  std::vector<double> run_original(Sample const &sample, std::vector<LaterCall> const &later) {
    std::vector<Sample> samples;
    for (LaterCall const &call : later) samples.push_back(call.sample);
    return original_->run(sample, samples);
  }

  // Compares later calls, each on the state that the original leaves. In mode fast, a difference counts only if the
  // original would give another output in a first call: rounding is judged by first calls.
  void compare_later(std::size_t k, std::vector<LaterCall> const &planned) {
    std::vector<std::pair<LaterCall, std::vector<double>>> calls; // and the original's outputs
    for (std::size_t call = 1; call < original_->calls(); ++call) {
      LaterCall const &plan = planned[call - 1];
      std::vector<double> const before = original_->outputs_of(call - 1);
      bool const as_planned = original_->next_inputs(plan.sample, before) == plan.sample.inputs;
      std::optional<LaterCall> now = as_planned ? plan : later_calls_.after(*original_, plan.sample, before);
      if (!now) break;
      calls.emplace_back(std::move(*now), original_->outputs_of(call));
    }
    for (auto const &[call, original] : calls) {
      bool const may_round = banner_.mode == FloatingPoint::fast && !all_near(original, call.outputs);
      if (may_round && all_same(original_->run(call.sample), original)) continue;
      for (std::size_t slot = 0; slot < original.size(); ++slot)
        is_named_ |=
            result_.called_again[slot].add(k, original[slot], call.outputs[slot], banner_.mode, options_.tolerance);
    }
  }

  // Compares the original beyond a guard, after calls of the generated code that it has not seen: it must not need
  // state from them. Failing or not ending beyond the guards says nothing.
  void compare_beyond(std::size_t k, Sample const &sample, std::vector<double> const &generated) {
    std::optional<Sample> const beyond = later_calls_.beyond_guards(*original_, sample, generated);
    if (!beyond) return;
    ++tried_beyond_;
    try {
      std::vector<double> const alone = original_->run(*beyond, {}, seconds_beyond);
      (void)original_->run(sample, {&*beyond, 1}, seconds_beyond);
      if (original_->calls() < 2) return;
      std::vector<double> const after = original_->outputs_of(1);
      for (std::size_t slot = 0; slot < alone.size(); ++slot)
        if (after[slot] != replay::spoilt_output) // the original writes this output
          is_named_ |= result_.called_beyond[slot].add(k, after[slot], alone[slot], FloatingPoint::strict, 0);
    } catch (DiagnosticError const &) {
      tried_beyond_ = most_beyond;
    }
  }

  // Adds a comparison. In mode fast a difference beyond the tolerance may be the original's own error.
  void add(OutputComparison &output, std::size_t k, std::size_t slot, double original, double generated) {
    bool const is_same = same(original, generated, banner_.mode, options_.tolerance);
    if (!is_same && banner_.mode == FloatingPoint::fast &&
        exact_.accepts(slot, original, generated, options_.tolerance))
      is_named_ |= output.add_same(k, original, generated);
    else
      is_named_ |= output.add(k, original, generated, banner_.mode, options_.tolerance);
  }

  static void keep_worst(std::vector<std::uint64_t> &worst, std::vector<double> const &one,
                         std::vector<double> const &other) {
    for (std::size_t slot = 0; slot < worst.size(); ++slot)
      worst[slot] = std::max(worst[slot], ulp_distance(one[slot], other[slot]));
  }

  static bool all_same(std::vector<double> const &one, std::vector<double> const &other) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](double a, double b) { return same(a, b, FloatingPoint::strict, 0); });
  }

  bool all_near(std::vector<double> const &one, std::vector<double> const &other) const {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [&](double a, double b) { return same(a, b, FloatingPoint::fast, options_.tolerance); });
  }

  bool is_left_by_generated(replay::LeftBehind const &left) const {
    return std::find(left_by_generated_.begin(), left_by_generated_.end(), left) != left_by_generated_.end();
  }

  bool is_scratch(replay::LeftBehind const &left) const {
    return left.region == memory::Region::static_object &&
           std::find(scratch_.begin(), scratch_.end(), local_name(left.name)) != scratch_.end();
  }

  // Checks that the wrapper passes on the code's outputs and touches nothing else.
  void compare_wrapper(std::size_t k, Sample const &sample, std::vector<double> const &generated) {
    std::vector<double> const wrapped = wrapped_->run(sample);
    for (std::size_t slot = 0; slot < wrapped.size(); ++slot)
      is_named_ |= result_.wrapped[slot].add(k, generated[slot], wrapped[slot], FloatingPoint::strict, 0);
    for (replay::LeftBehind const &left : wrapped_->left_behind())
      if (!is_left_by_generated(left)) add_left(result_.left_by_wrapper, describe(left));
    if (wrapped_->returned() != returned_) add_left(result_.missed_by_wrapper, "in what it returns besides numbers");
    compare_wrapped_calls(k, sample, generated);
    if (tried_wrapped_.size() < most_varied) tried_wrapped_.push_back(sample);
  }

  // Checks later calls, one beyond a guard if possible: the program with the wrapper must act as the original.
  void compare_wrapped_calls(std::size_t k, Sample const &sample, std::vector<double> const &generated) {
    bool const has_answer = banner_.mode != FloatingPoint::fast && !code_.needs_program() && banner_.has_values;
    if (!has_answer || tried_wrapped_calls_ >= most_beyond) return; // errors propagate, or no evaluator
    ++tried_wrapped_calls_;
    std::vector<Sample> later;
    if (std::optional<Sample> beyond = later_calls_.beyond_guards(*original_, sample, generated))
      later.push_back(std::move(*beyond));
    for (LaterCall &call : later_calls_.inside(*original_, sample, generated))
      if (later.size() < Replay::most_later) later.push_back(std::move(call.sample));
    try {
      (void)original_->run(sample, later, seconds_beyond);
    } catch (DiagnosticError const &) {
      tried_wrapped_calls_ = most_beyond;
      return;
    }
    (void)wrapped_->run(sample, later);
    for (std::size_t call = 1; call < std::min(original_->calls(), wrapped_->calls()); ++call) {
      std::vector<double> const inputs = original_->next_inputs(later[call - 1], original_->outputs_of(call - 1));
      Evaluation const evaluated = evaluate_sample(graph_, inputs, later[call - 1].parameters);
      bool const is_refused = evaluated.failing_guard < graph_.guards.size();
      if (!is_refused && !evaluated.premises.hold_in(banner_.mode)) return;
      std::vector<double> const original = original_->outputs_of(call), wrapped = wrapped_->outputs_of(call);
      for (std::size_t slot = 0; slot < original.size(); ++slot) {
        // Beyond a guard the wrapper calls the original; NaNs are equal there.
        bool const is_nan = is_refused && std::isnan(original[slot]) && std::isnan(wrapped[slot]);
        if (original[slot] != replay::spoilt_output && !is_nan) // the original writes this output
          is_named_ |= result_.wrapped[slot].add(k, original[slot], wrapped[slot], banner_.mode, options_.tolerance);
      }
    }
  }

  // Effects that the recording already reports (frozen state) are skipped.
  void add_outside(replay::OutsideEffect const &effect) {
    if (effect.kind != replay::Outside::result)
      return add_left(effect.kind == replay::Outside::lasts ? result_.changes_outside : result_.outside, effect.what);
    bool const is_known =
        std::ranges::any_of(graph_.frozen, [&](Frozen const &one) { return one.name == effect.what; });
    if (!is_known) add_left(result_.changes_outside, "reads '" + std::string(effect.what) + "'");
  }

  static void add_left(std::vector<LeftState> &all, std::string const &name) {
    for (LeftState &one : all)
      if (one.name == name) return void(++one.samples);
    all.push_back({name, 1});
  }

  Front const &front_;
  RunOptions const &run_;
  Recorded const &recorded_;
  VerificationOptions const &options_;
  std::optional<Graph> completed_; // if the kernel calls functions of the program and has derivatives
  Graph const &graph_;
  std::vector<std::string> const &scratch_;
  rewrite::Result const &annotated_;
  rewrite::Kernel const &kernel_;
  Banner const &banner_;
  GeneratedCode code_;
  std::optional<GeneratedCode> own_code_;
  SampleSource source_;
  LaterCalls later_calls_;
  ExactValues exact_;
  std::optional<ExactErrors> errors_;
  std::optional<ThreadVerification> threads_;
  std::optional<DerivativeVerification> derivatives_;
  std::optional<Sample> timed_;      // first sample within the premises and all guards
  std::optional<SingleRuns> single_; // of the current sample, in single precision
  std::unique_ptr<Replay> original_, rewritten_, own_flags_, wrapped_, covered_;
  std::string wrapped_program_;
  std::uint64_t returned_ = 0; // hash of the original's non-numeric result on the last sample
  std::vector<Sample> tried_wrapped_, tried_next_;
  bool asks_next_call_ = false;
  Symbolizer symbolizer_; // of the original
  static constexpr unsigned most_examined = 2;
  unsigned examined_ = 0;
  static constexpr std::size_t most_varied = 4;
  CoveredRun covered_run_;
  static constexpr std::size_t most_beyond = 100; // samples followed by one beyond the guards
  static constexpr unsigned seconds_beyond = 1;
  std::size_t tried_beyond_ = 0, tried_wrapped_calls_ = 0;
  std::vector<replay::LeftBehind> left_by_generated_;
  std::vector<symreal::Decision> decisions_;
  std::vector<double> values_; // of the recorded graph, at the current sample
  static constexpr std::size_t least_named = 1000;
  static constexpr double least_apart = 0x1p-20; // distance of samples on both sides of a boundary that rounding moves
  std::size_t most_named_ = least_named;
  bool is_named_ = false; // a result refers to the current sample
  Verification result_;
};

} // namespace

Verification verify(Front const &front, RunOptions const &run, Recorded const &recorded, std::string const &path,
                    Banner const &banner, VerificationOptions const &options) {
  return Verifier(front, run, recorded, path, banner, options).run();
}

} // namespace symreal::program
