// --parallel: lets threads share an evaluation if measured costs say that it pays.
#pragma once

#include "engine/plan/schedule/schedule.h"

#include <CLI/CLI.hpp>
#include <string>

namespace symreal::tool {

struct ParallelOption {
  unsigned threads = 1;
  std::string cost;

  void add_to(CLI::App &app);
  bool is_given() const { return threads != 1; }
  // The schedule distributed among threads; unchanged without --parallel. `remark`: the expected gain, in words. Throws
  // cost_file, bad_option, parallel_does_not_pay.
  Plan shared(Plan plan, std::string &remark) const;
};

} // namespace symreal::tool
