#include "tool/report/frozen.h"

#include "engine/graph/frozen.h"
#include "tool/options/options.h"

namespace symreal::tool {

void FrozenOption::add_to(CLI::App &app) {
  app.add_option(
         "--frozen", policy,
         "Treatment of baked-in values: state (an error, except for locals around a block), error (all), warn or allow")
      ->capture_default_str();
}

void FrozenOption::require_sense() const { require_one_of("--frozen", policy, "state|error|warn|allow"); }

bool report_frozen(std::vector<program::Recorded> const &kernels, FrozenOption const &option, Console &console) {
  bool is_error = false;
  for (program::Recorded const &recorded : kernels) {
    std::size_t last = recorded.graph.frozen.size(); // index of the last state that is reported
    for (std::size_t i = 0; i < recorded.graph.frozen.size(); ++i)
      if (frozen_severity(recorded.graph.frozen[i], option.policy)) last = i;
    auto const clause = recorded.clauses.find("constant");
    for (std::size_t i = 0; i < recorded.graph.frozen.size(); ++i) {
      Frozen const &state = recorded.graph.frozen[i];
      std::optional<Severity> const severity = frozen_severity(state, option.policy);
      if (!severity) continue;
      is_error = is_error || *severity == Severity::error;
      Diagnostic diagnostic{
          DiagnosticId::frozen_state, state.place, frozen_message(recorded.kernel.name, state), {}, *severity};
      if (i < recorded.frozen_reads.size()) diagnostic.notes = recorded.frozen_reads[i];
      if (i == last && clause != recorded.clauses.end())
        diagnostic.notes.push_back(program::clause_note(recorded.kernel, {*clause}, ", if they may be kept"));
      console.report(diagnostic);
    }
  }
  return !is_error;
}

} // namespace symreal::tool
