#include "tool/options/decisions_option.h"

#include "engine/support/files.h"
#include "program/build/durable_files.h"
#include "tool/options/options.h"

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

} // namespace symreal::tool
