#include "tool/options/decisions_option.h"

#include "engine/support/files.h"
#include "program/build/durable_files.h"
#include "tool/options/options.h"

namespace symreal::tool {

void DecisionsOption::add_to(CLI::App &app) {
  app.add_option("--decisions", policy,
                 "What to do at a decision on a symbolic value: error, guard, select, explore or auto")
      ->capture_default_str();
  max_paths = app.add_option("--max-paths", bounds.paths, "explore, auto: how many paths of a kernel are recorded")
                  ->check(CLI::Range(1, 100000))
                  ->capture_default_str();
  max_depth = app.add_option("--max-depth", bounds.depth, "explore, auto: how many decisions a path has")
                  ->check(CLI::Range(1, 10000))
                  ->capture_default_str();
  zero_tests = app.add_option("--zero-tests", zeros,
                              "explore, auto: tests for exact zero become guards (guard) or paths (explore)")
                   ->capture_default_str();
  met = app.add_option("--paths-met", paths_met,
                       "explore, auto: a table of samples (CSV); a guard refuses each branch that none of them takes")
            ->type_name("FILE");
  join = app.add_option("--joins", joins,
                        "explore, auto: ways that come to the same state again are one path (on), or each a path (off)")
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
