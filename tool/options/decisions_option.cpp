#include "tool/options/decisions_option.h"

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
  join = app.add_option("--joins", joins,
                        "explore, auto: ways that come to the same state again are one path (on), or each a path (off)")
             ->capture_default_str();
}

void DecisionsOption::require_sense() const {
  require_one_of("--decisions", policy, "error|guard|select|explore|auto");
  require_one_of("--zero-tests", zeros, "guard|explore");
  require_one_of("--joins", joins, "on|off");
  if (is_exploring()) return;
  for (CLI::Option const *bound : {max_paths, max_depth, zero_tests, join})
    if (bound->count() != 0)
      fail(DiagnosticId::option_without_effect, {},
           bound->get_name() + " has no effect without --decisions=explore or auto");
}

std::string DecisionsOption::of_recording() const {
  program::ExploreBounds all = bounds;
  all.zeros = zeros == "explore";
  all.joins = joins == "on";
  all.selects = policy == "auto";
  return is_exploring() ? program::explore_policy(all) : policy;
}

} // namespace symreal::tool
