#include "tool/options/reroll_option.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/optimise/passes/pass.h"

#include <algorithm>

namespace symreal::tool {

void RerollOption::add_to(CLI::App &app) {
  app.add_flag("--reroll", is_given, "Emit repeated operations as loops over tables (C or C++)");
}

void RerollOption::require_sense(EmitterOptions const &emitter, bool is_parallel) const {
  if (!is_given) return;
  if (is_parallel)
    fail(DiagnosticId::bad_option, {}, "--parallel shares out statements, which --reroll makes loops of");
  if (emitter.check_values)
    fail(DiagnosticId::bad_option, {}, "--check-values makes a statement of each operation, and --reroll loops");
}

std::optional<Rerolled> RerollOption::loops(Schedule const &plan, std::optional<Rerolled> const &found,
                                            PassOptions const &passes, std::vector<Diagnostic> &remarks,
                                            std::string &text) const {
  if (!is_given) return {};
  auto const improve = [&](Graph graph, bool in_loop) {
    PassSettings settings = passes.settings();
    std::vector<std::string> names = passes.names();
    if (in_loop)
      std::erase(names, "latency"); // iterations run side by side: recurrences.h
    else
      settings.effort = std::min(settings.effort, 1); // code that runs once
    return run_passes(std::move(graph), names, settings);
  };
  Rerolled loops = found ? improved(*found, plan.angles, improve) : rerolled(plan, passes.settings().mode);
  if (!loops.has_loops()) {
    remarks.push_back(
        {DiagnosticId::not_rerolled, {}, "kernel '" + plan.graph->kernel + "' is not re-rolled: " + loops.why_not});
    return {};
  }
  text = describe(loops);
  return loops;
}

} // namespace symreal::tool
