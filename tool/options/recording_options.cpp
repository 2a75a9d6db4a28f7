#include "tool/options/recording_options.h"

#include "engine/graph/graph.h"
#include "engine/graph/graph_line.h"
#include "engine/support/files.h"
#include "program/build/durable_files.h"
#include "tool/options/option_table.h"

#include <algorithm>
#include <optional>

namespace symreal::tool {

namespace {

std::size_t number_up_to(std::size_t most, std::string const &text) {
  std::optional<std::uint32_t> const number = parse_natural(text);
  return number && *number <= most ? *number : 0;
}

void take_limit(std::string const &limit, program::ExploreBounds &bounds) {
  std::size_t const end = std::min(limit.find('='), limit.size());
  std::string const name = limit.substr(0, end), value = end == limit.size() ? "" : limit.substr(end + 1);
  bool is_known = true;
  if (name == "paths")
    is_known = (bounds.paths = number_up_to(100'000, value)) != 0;
  else if (name == "depth")
    is_known = (bounds.depth = number_up_to(10'000, value)) != 0;
  else if (name == "zeros")
    is_known = (bounds.zeros = value == "explore") || value == "guard";
  else if (name == "joins")
    is_known = (bounds.joins = value == "on") || value == "off";
  else
    is_known = false;
  if (!is_known)
    fail(DiagnosticId::bad_option, {},
         "--explore takes paths=1..100000, depth=1..10000, zeros=guard|explore and joins=on|off, not '" + limit + "'");
}

// The limits of --explore.
program::ExploreBounds bounds_of(std::vector<std::string> const &limits) {
  program::ExploreBounds bounds;
  for (std::string const &limit : limits) take_limit(limit, bounds);
  return bounds;
}

} // namespace

void DecisionsOption::add_to(CLI::App &app) {
  app.add_option("--decisions", policy,
                 "Treatment of decisions on symbolic values: error, guard, select, explore or auto")
      ->capture_default_str();
  explore = app.add_option("--explore", limits,
                           "Limits of explore and auto: paths=128 of a kernel, depth=64 decisions of a path, "
                           "zeros=guard|explore for tests for exact zero, joins=on|off for paths that meet again")
                ->type_name("LIMIT=VALUE,...")
                ->delimiter(',')
                ->allow_extra_args(false);
  met = app.add_option("--paths-met", paths_met,
                       "Table of samples (CSV); guards refuse branches that no sample takes (explore, auto)")
            ->type_name("FILE");
}

void DecisionsOption::require_sense() const {
  require_one_of("--decisions", policy, "error|guard|select|explore|auto");
  (void)bounds_of(limits);
  if (is_exploring()) return;
  for (CLI::Option const *bound : {explore, met})
    if (bound->count() != 0)
      fail(DiagnosticId::option_without_effect, {},
           bound->get_name() + " has no effect without --decisions=explore or auto");
}

std::string met_hash(std::string const &file) {
  constexpr std::size_t digits = 16; // enough to distinguish tables
  return program::content_hash(read_file(file)).substr(0, digits);
}

std::string DecisionsOption::of_recording() const {
  program::ExploreBounds all = bounds_of(limits);
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
