#include "program/verification.h"

#include "graph/evaluate.h"
#include "program/guard_verification.h"
#include "program/replay.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal::program {

std::size_t Verification::different() const {
  return static_cast<std::size_t>(std::count_if(outputs.begin(), outputs.end(),
                                                [](OutputComparison const &output) { return output.different != 0; }));
}

Recorded const &require_match(std::vector<Recorded> const &kernels, Banner const &banner, std::string const &path) {
  auto found = std::find_if(kernels.begin(), kernels.end(),
                            [&](Recorded const &kernel) { return kernel.graph.kernel == banner.kernel; });
  if (found == kernels.end())
    fail(DiagnosticId::foreign_file, {path, 1, 1}, "the sources have no kernel '" + banner.kernel + "'");
  Graph const &graph = found->graph;
  if (graph.input_count() != banner.inputs || graph.parameter_count() != banner.parameters ||
      graph.output_count() != banner.outputs)
    fail(DiagnosticId::foreign_file, {path, 1, 1},
         fmt::format("kernel '{}' has {} inputs, {} parameters and {} outputs, the file {}, {} and {}", banner.kernel,
                     graph.input_count(), graph.parameter_count(), graph.output_count(), banner.inputs,
                     banner.parameters, banner.outputs));
  return *found;
}

Verification verify(Front const &front, RunOptions const &run, Recorded const &recorded, std::string const &path,
                    Banner const &banner, VerificationOptions const &options) {
  Graph const &graph = recorded.graph;
  GeneratedCode code(path, banner, graph, *front.workspace);
  Replay replay(front.replay_program, run, recorded.begun_as, graph, *front.workspace,
                code.needs_program() ? &code : nullptr);
  std::optional<Replay> own_flags;
  if (!front.own_flags_program.empty())
    own_flags.emplace(front.own_flags_program, run, recorded.begun_as, graph, *front.workspace);
  SampleSource source(graph, options.seed);
  Verification result;
  result.mode = banner.mode;
  result.outputs.resize(graph.output_count());
  for (std::size_t number = 1; number <= banner.guards; ++number)
    result.guards.push_back({code.guard_text(number), 0, {}});
  if (own_flags) result.own_flags_ulp.resize(graph.output_count());

  for (std::size_t k = 0; k < options.samples; ++k) {
    Sample sample = source.next();
    Evaluation const evaluated =
        code.needs_program() ? replay.run_graph(sample) : evaluate_sample(graph, sample.inputs, sample.parameters);
    GeneratedCode::Result const computed =
        code.needs_program() ? replay.run_generated(sample) : code.run(sample.inputs, sample.parameters);
    std::vector<double> const &generated = computed.outputs;
    Premises const &premises = evaluated.premises;
    bool inside = premises.defined && (banner.mode == FloatingPoint::strict || premises.hold());
    if (!premises.defined)
      ++result.undefined;
    else if (!inside)
      ++(premises.finite ? result.zero_sign : result.not_finite);
    std::size_t const failing = evaluated.failing_guard;
    result.samples.push_back(sample);
    if (inside) check_guards(graph, failing, computed, k, result);
    // Beyond a guard the original goes where the recording has not been, and nothing is promised.
    if (failing < graph.guards.size() || computed.failed != 0 || !premises.defined) continue;
    std::vector<double> original = replay.run(sample);
    bool graph_same = true, outside_same = true;
    for (std::size_t slot = 0; slot < original.size(); ++slot) {
      if (inside) {
        result.outputs[slot].add(k, original[slot], generated[slot], banner.mode, options.tolerance);
        graph_same &= same(original[slot], evaluated.outputs[slot], FloatingPoint::strict, 0);
      } else {
        outside_same &= same(original[slot], generated[slot], FloatingPoint::strict, 0);
      }
    }
    if (own_flags && inside) {
      std::vector<double> own = own_flags->run(sample);
      for (std::size_t slot = 0; slot < own.size(); ++slot)
        result.own_flags_ulp[slot] = std::max(result.own_flags_ulp[slot], ulp_distance(own[slot], generated[slot]));
    }
    result.inside += inside;
    result.outside_different += !outside_same;
    result.graph_different += !graph_same;
  }
  return result;
}

} // namespace symreal::program
