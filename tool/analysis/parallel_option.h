// --parallel: lets threads share an evaluation if measured costs say that it pays.
#pragma once

#include "engine/analysis/sharing/sharing.h"
#include "tool/options/options.h"

#include <string>

namespace symreal::tool {

struct ParallelOption {
  unsigned threads = 1;
  std::string cost;

  void add_to(CLI::App &app);
  bool is_given() const { return threads != 1; }
  // Throws option_without_effect, bad_option.
  void require_sense(EmitterOptions const &emitter) const;
  // The schedule distributed among threads; unchanged without --parallel. `remark`: the expected gain, in words. Throws
  // cost_file, bad_option, parallel_does_not_pay.
  Schedule shared(Schedule plan, std::string &remark) const;
};

} // namespace symreal::tool
