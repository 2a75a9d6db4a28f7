// --reroll: turns repetitions into loops.
#pragma once

#include "engine/plan/reroll/reroll.h"
#include "tool/options/options.h"

namespace symreal::tool {

struct RerollOption {
  bool is_given = false;

  void add_to(CLI::App &app);
  // Throws bad_option, option_without_effect.
  void require_sense(EmitterOptions const &emitter, bool is_parallel) const;
  // The loops; nullopt if not requested or not found, with a remark why. `text`: their share of the code. `found`:
  // loops that were found already, whose computed values passes then work on.
  std::optional<Rerolled> loops(Schedule const &plan, std::optional<Rerolled> const &found, PassOptions const &passes,
                                std::vector<Diagnostic> &remarks, std::string &text) const;
};

} // namespace symreal::tool
