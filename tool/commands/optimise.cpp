#include "tool/commands/optimise.h"

#include "engine/graph/statistics.h"
#include "engine/optimise/passes/pass.h"
#include "engine/support/progress.h"
#include "tool/output/outputs.h"

#include <iostream>
#include <utility>

namespace symreal::tool {

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
  Rerolled loops =
      rerolled(as_emitted(schedule(result.graph, emitter.nesting()), emitter, options.floating_point(), languages),
               options.floating_point());
  if (!loops.has_loops()) return optimise(std::move(recorded), options, report);
  for (Diagnostic const &remark : remarks) report ? report(remark) : print(std::cerr, remark);
  result.loops = std::move(loops);
  return result;
}

} // namespace symreal::tool
