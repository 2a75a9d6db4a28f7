#include "tool/commands/optimise.h"

#include "engine/graph/evaluate.h"
#include "engine/graph/external.h"
#include "engine/graph/names.h"
#include "engine/graph/statistics.h"
#include "engine/optimise/passes/pass.h"
#include "engine/optimise/passes/snap.h"
#include "engine/support/number.h"
#include "engine/support/progress.h"
#include "runtime/replay/samples.h"
#include "tool/commands/planned_code.h"
#include "verify/exact_values.h"

#include <algorithm>
#include <fmt/format.h>
#include <iostream>
#include <utility>

namespace symreal::tool {
namespace {

std::string in_words(SnappedConstant const &constant) {
  return fmt::format("{} counts as {}, in {} place{}", shortest(constant.value), shortest(constant.exact),
                     constant.uses, constant.uses == 1 ? "" : "s");
}

// Does the graph call external functions, which cannot be evaluated here?
bool calls_out(Graph const &graph) {
  return std::ranges::any_of(graph.externals, [](External const &one) { return !find_complex_function(one); });
}

void tell(Graph const &graph, std::vector<SnappedConstant> const &constants, Report const &report) {
  constexpr std::size_t most_alone = 4;
  std::vector<Note> notes;
  if (calls_out(graph))
    notes.push_back({{},
                     "whether outputs change is not tried here, since the kernel calls external functions: symreal "
                     "verify tries it"});
  if (constants.size() <= most_alone) {
    for (SnappedConstant const &constant : constants)
      report({DiagnosticId::snapped_constant, place_at(graph, constant.location), in_words(constant), notes});
    return;
  }
  for (SnappedConstant const &constant : constants)
    notes.push_back({place_at(graph, constant.location), in_words(constant)});
  report({DiagnosticId::snapped_constant, place_at(graph, constants.front().location),
          fmt::format("{} constants count as exact numbers", constants.size()), std::move(notes)});
}

// Finds the first output that changes by more than the tolerance.
class Change {
public:
  Change(Graph const &before, Graph const &after, double tolerance)
      : before_(before),
        after_(after),
        tolerance_(tolerance),
        exact_(before) {}

  // Describes the change on a sample; empty if no output changes.
  std::string at(Sample const &sample) {
    Evaluation const old = evaluate_sample(before_, sample.inputs, sample.parameters);
    if (!old.premises.hold() || old.failing_guard < before_.guards.size()) return {};
    Evaluation const now = evaluate_sample(after_, sample.inputs, sample.parameters);
    exact_.begin(sample.inputs, sample.parameters);
    for (std::uint32_t slot = 0; slot < old.outputs.size(); ++slot) {
      double const from = old.outputs[slot], to = now.outputs[slot];
      if (!same(from, to, FloatingPoint::fast, tolerance_) && !exact_.accepts(slot, from, to, tolerance_))
        return fmt::format("{} changes from {} to {}",
                           element_name(before_.outputs, slot).value_or("output " + std::to_string(slot)),
                           shortest(from), shortest(to));
    }
    return {};
  }

private:
  Graph const &before_, &after_;
  double tolerance_;
  program::ExactValues exact_;
};

void require_same_outputs(Graph const &recorded, Snapped const &snapped, double tolerance) {
  constexpr std::size_t work = 20'000'000, fewest = 5, most = 100;
  std::size_t const samples = std::clamp(work / (recorded.nodes.size() + 1), fewest, most);
  Change change(recorded, snapped.graph, tolerance);
  SampleSource source(recorded, 1, true);
  for (std::size_t k = 0; k < samples; ++k) {
    Sample const sample = source.next();
    std::string const changed = change.at(sample);
    if (changed.empty()) continue;
    std::vector<Note> notes;
    for (SnappedConstant const &constant : snapped.constants)
      notes.push_back({place_at(recorded, constant.location), in_words(constant)});
    fail(DiagnosticId::snap_changes_output, place_at(recorded, snapped.constants.front().location),
         fmt::format("{}{}, by more than {} of the larger of its magnitude and 1", changed,
                     k == 0 ? " on the recorded inputs" : "", shortest(tolerance)),
         std::move(notes));
  }
}

std::size_t operations(Graph const &graph, PassSettings const &settings) {
  Graph const simple = pass_simplify(pass_cull(Graph(graph), settings), settings);
  std::vector<char> const live = live_nodes(simple);
  OperationCounts counts; // without operations on parameters
  for (std::size_t id = 0; id < simple.nodes.size(); ++id)
    if (live[id] && simple.nodes[id].attribute == Attribute::variable) ++counts[simple.nodes[id].op];
  return counts.arithmetic();
}

// The graph with exact constants, each reported. Samples check it: throws snap_changes_output if an output changes by
// more than the tolerance.
Graph with_exact_constants(Graph const &recorded, double distance, double tolerance, Report const &report) {
  Snapped snapped = snap_constants(recorded, distance);
  if (snapped.constants.empty()) return recorded;
  if (!calls_out(recorded)) require_same_outputs(recorded, snapped, tolerance);
  tell(recorded, snapped.constants, report);
  return std::move(snapped.graph);
}

// Reports the operations that exact constants would save in mode fast, by rules alone, if any.
void tell_of_exact_constants(Graph const &recorded, PassSettings const &settings, Report const &report) {
  Snapped const snapped = snap_constants(recorded, usual_snap);
  if (snapped.constants.empty()) return;
  std::size_t const now = operations(recorded, settings), then = operations(snapped.graph, settings);
  if (then >= now) return;
  SnappedConstant const &first = snapped.constants.front();
  report({DiagnosticId::snap_would_save, place_at(recorded, first.location),
          fmt::format("{} of {} operations compute with constants that are nearly exact, such as {} for {}", now - then,
                      now, shortest(first.value), shortest(first.exact))});
}

} // namespace

Optimised optimise(Graph recorded, PassOptions const &options, Report const &report, bool searches) {
  PassSettings settings = options.settings();
  settings.searches = searches;
  Optimised result{{}, {{"recorded", live_operations(recorded)}}, counts_of(recorded)};
  Report const tell = report ? report : [](Diagnostic const &remark) { print(std::cerr, remark); };
  settings.tell = tell;
  if (std::optional<double> const distance = options.snap_distance()) {
    recorded = with_exact_constants(recorded, *distance, options.tolerance, tell);
    result.stages.push_back({"snap", live_operations(recorded)});
  } else if (settings.mode == FloatingPoint::fast && !options.names().empty()) {
    tell_of_exact_constants(recorded, settings, tell);
  }
  result.graph = std::move(recorded);
  Progress progress("passes", options.names().size());
  for (std::string const &pass : options.names()) {
    progress.add();
    if (!find_pass(pass).runs_in(settings.mode)) continue; // a skipped pass is not a stage
    result.graph = run_passes(std::move(result.graph), {&pass, 1}, settings);
    result.stages.push_back({pass, live_operations(result.graph)});
  }
  return result;
}

Optimised optimise_around_loops(Graph recorded, PassOptions const &options, EmitterOptions const &emitter,
                                std::vector<Language const *> const &languages, Report const &report) {
  if (options.floating_point() != FloatingPoint::fast || options.settings().effort == 0)
    return optimise(std::move(recorded), options, report);
  std::vector<Diagnostic> remarks;
  Optimised result = optimise(recorded, options, [&](Diagnostic const &remark) { remarks.push_back(remark); }, false);
  Rerolled loops = rerolled(
      with_wished_angles(schedule(result.graph, emitter.nesting()), emitter, options.floating_point(), languages),
      options.floating_point());
  if (!loops.has_loops()) return optimise(std::move(recorded), options, report);
  for (Diagnostic const &remark : remarks) report ? report(remark) : print(std::cerr, remark);
  result.loops = std::move(loops);
  return result;
}

} // namespace symreal::tool
