#include "tool/options/recording_options.h"

#include "engine/graph/graph.h"
#include "engine/support/files.h"
#include "program/build/durable_files.h"
#include "tool/options/option_table.h"

#include <optional>

namespace symreal::tool {

void DecisionsOption::add_to(CLI::App &app) {
  app.add_option("--decisions", policy,
                 "Treatment of decisions on symbolic values: error, guard, select, explore or auto")
      ->capture_default_str();
  max_paths = app.add_option("--max-paths", bounds.paths, "Maximum paths per kernel (explore, auto)")
                  ->check(CLI::Range(1, 100000))
                  ->capture_default_str();
  max_depth = app.add_option("--max-depth", bounds.depth, "Maximum decisions per path (explore, auto)")
                  ->check(CLI::Range(1, 10000))
                  ->capture_default_str();
  zero_tests =
      app.add_option("--zero-tests", zeros, "Treatment of tests for exact zero: guard or explore (explore, auto)")
          ->capture_default_str();
  met = app.add_option("--paths-met", paths_met,
                       "Table of samples (CSV); guards refuse branches that no sample takes (explore, auto)")
            ->type_name("FILE");
  join = app.add_option("--joins", joins, "Merge paths that reach the same state again, on or off (explore, auto)")
             ->capture_default_str();
}

void DecisionsOption::require_sense() const {
  require_one_of("--decisions", policy, "error|guard|select|explore|auto");
  require_one_of("--zero-tests", zeros, "guard|explore");
  require_one_of("--joins", joins, "on|off");
  if (is_exploring()) return;
  for (CLI::Option const *bound : {max_paths, max_depth, zero_tests, join, met})
    if (bound->count() != 0)
      fail(DiagnosticId::option_without_effect, {},
           bound->get_name() + " has no effect without --decisions=explore or auto");
}

std::string met_hash(std::string const &file) {
  constexpr std::size_t digits = 16; // enough to distinguish tables
  return program::content_hash(read_file(file)).substr(0, digits);
}

std::string DecisionsOption::of_recording() const {
  program::ExploreBounds all = bounds;
  all.zeros = zeros == "explore";
  all.joins = joins == "on";
  all.selects = policy == "auto";
  if (!paths_met.empty()) all.met = met_hash(paths_met);
  return is_exploring() ? program::explore_policy(all) : policy;
}

void FrozenOption::add_to(CLI::App &app) {
  app.add_option(
         "--frozen", policy,
         "Treatment of baked-in values: state (an error, except for locals around a block), error (all), warn or allow")
      ->capture_default_str();
}

void FrozenOption::require_sense() const { require_one_of("--frozen", policy, "state|error|warn|allow"); }

bool FrozenOption::accepts(std::vector<program::Recorded> const &kernels, Report const &report) const {
  bool is_error = false;
  for (program::Recorded const &recorded : kernels) {
    std::size_t last = recorded.graph.frozen.size(); // index of the last state that is reported
    for (std::size_t i = 0; i < recorded.graph.frozen.size(); ++i)
      if (frozen_severity(recorded.graph.frozen[i], policy)) last = i;
    auto const clause = recorded.clauses.find("constant");
    for (std::size_t i = 0; i < recorded.graph.frozen.size(); ++i) {
      Frozen const &state = recorded.graph.frozen[i];
      std::optional<Severity> const severity = frozen_severity(state, policy);
      if (!severity) continue;
      is_error = is_error || *severity == Severity::error;
      Diagnostic diagnostic{
          DiagnosticId::frozen_state, state.place, frozen_message(recorded.kernel.name, state), {}, *severity};
      if (i < recorded.frozen_reads.size()) diagnostic.notes = recorded.frozen_reads[i];
      if (i == last && clause != recorded.clauses.end())
        diagnostic.notes.push_back(program::clause_note(recorded.kernel, {*clause}, ", if they may be kept"));
      report(diagnostic);
    }
  }
  return !is_error;
}

} // namespace symreal::tool
