#include "runtime/trace/sinks.h"

#include "engine/emit/emit.h"
#include "engine/emit/language/banner.h"
#include "engine/graph/graph.h"
#include "engine/optimise/differentiate/differentiate.h"
#include "engine/optimise/passes/pass.h"
#include "engine/plan/schedule/schedule.h"
#include "engine/support/files.h"
#include "runtime/trace/report/events.h"
#include "runtime/wire/request.h"

#include <cstdlib>
#include <filesystem>

namespace symreal::trace {

// Applies the entry `frozen` of the request, the counterpart of --frozen.
static void report_frozen(Graph const &graph) {
  char const *wanted = wire::requested(wire::Entry::frozen);
  std::string const policy = wanted ? wanted : "state";
  for (Frozen const &state : graph.frozen)
    if (std::optional<Severity> const severity = frozen_severity(state, policy))
      report({DiagnosticId::frozen_state, state.place, frozen_message(graph.kernel, state), {}, *severity});
}

void generate_here(Graph const &graph, std::string const &output_file) {
  report_frozen(graph);
  if (anything_wrong()) give_up(); // errors are printed already
  std::vector<std::string> const passes = default_passes();
  Graph const wanted = differentiate(graph, graph.wishes, [](Diagnostic const &warning) { report(warning); });
  std::filesystem::path const path = output_file.empty() ? graph.kernel + ".c" : output_file;
  Graph const optimised = run_passes(wanted, passes, FloatingPoint::finite);
  std::vector<EmittedFile> const files =
      emit(schedule(optimised), *find_language("c"), {.base_name = path.stem().string()});
  for (EmittedFile const &file : files) require_ours((path.parent_path() / file.name).string(), file.text);
  for (EmittedFile const &file : files) write_if_changed((path.parent_path() / file.name).string(), file.text);
}

} // namespace symreal::trace
